#include "engine/files/geographic.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <cmath>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "engine/base/text.hpp"
#include "lober/curve/files.hpp"

namespace lober::detail {
namespace {

// The words of a header in small letters.
std::vector<std::string> words_of(std::string_view header) {
  std::vector<std::string> words(1);
  for (const char letter : header) {
    if (std::isalpha(static_cast<unsigned char>(letter)) != 0) {
      words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  return words;
}

// Where one of the names is among the words; their number if it is not.
template <std::size_t n>
std::size_t word_among(const std::array<std::string_view, n>& names, const std::vector<std::string>& words) {
  const auto found = std::find_if(words.begin(), words.end(), [&](const std::string& word) {
    return std::find(names.begin(), names.end(), word) != names.end();
  });
  return static_cast<std::size_t>(found - words.begin());
}

struct Ranges {
  bool degrees = false;   ///< all points may be longitudes and latitudes
  bool half_way = false;  ///< some longitude is beyond 90 degrees, as one of both ends of a jump by 180 has to be
};

// Every curve that is read passes here: one pass, without a branch, parallel.
Ranges ranges_of(std::span<const Point> points, bool latitude_first) {
  std::atomic<bool> beyond = false, half_way = false;
  for_each_block(points.size(), std::size_t{1} << 16, [&](std::size_t first, std::size_t last) {
    bool no_degrees = false, far = false;
    for (const Point& point : points.subspan(first, last - first)) {
      const double longitude = std::fabs(latitude_first ? point.y : point.x);
      const double latitude = std::fabs(latitude_first ? point.x : point.y);
      no_degrees |= !(longitude <= 360) | !(latitude <= 90);
      far |= longitude > 90;
    }
    if (no_degrees) beyond = true;
    if (far) half_way = true;
  });
  return {!beyond, half_way};
}

struct Jumps {
  std::size_t count = 0, first = 0;  ///< segments that run half around the earth, and the first of them
  double largest_other = 0;          ///< steps of the others
  bool at_zero = false;              ///< the first is at the meridian of 0, where longitudes are those from 0 to 360
};

Jumps jumps_in(std::span<const Point> points, bool latitude_first) {
  Jumps jumps;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const double from = latitude_first ? points[k].y : points[k].x,
                 to = latitude_first ? points[k + 1].y : points[k + 1].x, step = std::fabs(to - from);
    if (step > 180) {
      if (jumps.count++ == 0) jumps.first = k, jumps.at_zero = from >= 0 && to >= 0;
    } else {
      jumps.largest_other = std::max(jumps.largest_other, step);
    }
  }
  return jumps;
}

// Longitude and latitude among the words of a header, as these name them, in their order.
struct NamedColumns {
  std::string first, second;
  bool latitude_first;
};

std::optional<NamedColumns> named_columns(const std::vector<std::string>& words) {
  constexpr std::array<std::string_view, 4> longitudes{"lon", "long", "lng", "longitude"};
  constexpr std::array<std::string_view, 2> latitudes{"lat", "latitude"};
  const std::size_t longitude = word_among(longitudes, words), latitude = word_among(latitudes, words);
  if (longitude == words.size() || latitude == words.size()) return std::nullopt;
  return NamedColumns{words[std::min(longitude, latitude)], words[std::max(longitude, latitude)], latitude < longitude};
}

// Facts about the columns of a curve.
struct Geography {
  std::optional<NamedColumns> named;
  bool degrees = false;               ///< the points are longitudes and latitudes
  std::optional<std::size_t> jump{};  ///< the first segment that runs back across the map
  bool at_zero = false;               ///< at the meridian of 0, not the date line

  [[nodiscard]] bool latitude_first() const { return named && named->latitude_first; }
  [[nodiscard]] std::string warning() const {
    if (!jump) return {};
    return "its segment " + std::to_string(*jump) + " runs back across the whole map where the curve crosses the " +
           (at_zero ? "meridian of 0" : "date line");
  }
  [[nodiscard]] std::string remedy() const {
    return at_zero ? "subtract 360 from longitudes above 180" : "add 360 to longitudes below 0";
  }
};

Geography geography_of(const std::vector<std::string>& words, std::span<const Point> points) {
  constexpr std::size_t enough = 16;
  constexpr double much_shorter = 30;  // degrees
  Geography found{named_columns(words)};
  if (!found.named && points.size() < enough) return found;
  const Ranges ranges = ranges_of(points, found.latitude_first());
  if (!ranges.degrees || (!found.named && !ranges.half_way)) return found;
  const Jumps jumps = jumps_in(points, found.latitude_first());
  if (jumps.count > 0 && jumps.largest_other < much_shorter) {
    found.jump = jumps.first;
    found.at_zero = jumps.at_zero;
  }
  found.degrees = found.named || found.jump;
  return found;
}

}  // namespace

std::optional<bool> latitude_first(std::string_view header) {
  const std::optional<NamedColumns> named = named_columns(words_of(header));
  return named ? std::optional(named->latitude_first) : std::nullopt;
}

ColumnsRemark columns_remark(std::string_view header, std::span<const Point> points) {
  const std::vector<std::string> words = words_of(header);
  if (words.size() >= 2 && words[0] == "y" && words[1] == "x") {
    return {"has columns named y and x, which are taken as x and y in that order", {}};
  }
  const Geography geography = geography_of(words, points);
  if (!geography.degrees) return {};
  ColumnsRemark remark{geography.named ? "has columns named " + geography.named->first + " and " +
                                             geography.named->second + ", which are taken as x and y in that order"
                                       : "looks like longitudes and latitudes, which are taken as x and y",
                       geography.warning()};
  remark.text += "; areas are those of the plane, in square degrees";
  if (!remark.warning.empty()) {
    remark.text += ", and " + remark.warning + ": " + geography.remedy() + ", or give the period " +
                   (geography.latitude_first() ? "y" : "x") + "=360";
  }
  return remark;
}

}  // namespace lober::detail

namespace lober {

std::string period_of_longitudes(const Curve& curve) {
  return std::string("periodic = \"") + (curve.latitude_first.value_or(false) ? "y" : "x") + "=360\"";
}

std::string date_line_warning(std::string_view header, std::span<const Point> points) {
  return detail::columns_remark(header, points).warning;
}

std::string longitudes_warning(const Curve& first, const Curve& second) {
  if (!first.latitude_first || first.latitude_first != second.latitude_first) return {};
  const bool swapped = *first.latitude_first;
  struct Range {
    double west, east, south, north;
    [[nodiscard]] bool in_degrees() const { return west >= -360 && east <= 360 && south >= -90 && north <= 90; }
    [[nodiscard]] std::string to_string() const {
      return "from " + detail::format_rounded(west, 6) + " to " + detail::format_rounded(east, 6);
    }
  };
  const auto range = [&](const Curve& curve) {
    Rectangle box;
    for (const Point& point : curve.points) box.add(point);
    return swapped ? Range{box.min_y, box.max_y, box.min_x, box.max_x}
                   : Range{box.min_x, box.max_x, box.min_y, box.max_y};
  };
  const Range one = range(first), other = range(second);
  if (!one.in_degrees() || !other.in_degrees() || one.north < other.south || other.north < one.south) return {};
  const auto meets = [&](double turn) { return one.west < other.east + turn && other.west + turn < one.east; };
  if (!meets(360) && !meets(-360)) return {};
  return "longitudes of " + first.name + " are " + one.to_string() + ", those of " + second.name + " " +
         other.to_string() + ": where they differ by 360 the curves are on the same place of the earth and do not meet";
}

}  // namespace lober
