#include "engine/files/geographic.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <cmath>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "engine/base/text.hpp"

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
};

Jumps jumps_in(std::span<const Point> points, bool latitude_first) {
  Jumps jumps;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const double step = std::fabs(latitude_first ? points[k + 1].y - points[k].y : points[k + 1].x - points[k].x);
    if (step > 180) {
      if (jumps.count++ == 0) jumps.first = k;
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

}  // namespace

std::optional<bool> latitude_first(std::string_view header) {
  const std::optional<NamedColumns> named = named_columns(words_of(header));
  return named ? std::optional(named->latitude_first) : std::nullopt;
}

std::string columns_remark(std::string_view header, std::span<const Point> points) {
  constexpr std::size_t enough = 16;
  constexpr double much_shorter = 30;  // degrees
  const std::vector<std::string> words = words_of(header);
  if (words.size() >= 2 && words[0] == "y" && words[1] == "x") {
    return "has columns named y and x, which are taken as x and y in that order";
  }
  const std::optional<NamedColumns> named = named_columns(words);
  if (!named && points.size() < enough) return {};
  const bool swapped = named && named->latitude_first;
  const Ranges ranges = ranges_of(points, swapped);
  if (!ranges.degrees || (!named && !ranges.half_way)) return {};
  const Jumps jumps = jumps_in(points, swapped);
  const bool crosses = jumps.count > 0 && jumps.largest_other < much_shorter;
  if (!named && !crosses) return {};
  std::string text = named ? "has columns named " + named->first + " and " + named->second +
                                 ", which are taken as x and y in that order"
                           : "looks like longitudes and latitudes, which are taken as x and y";
  text += "; areas are those of the plane, in square degrees";
  if (crosses) {
    text += ", and its segment " + std::to_string(jumps.first) +
            " runs back across the whole map where the curve crosses the date line: add 360 to longitudes below 0";
  }
  return text;
}

}  // namespace lober::detail
