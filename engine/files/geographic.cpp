#include "engine/files/geographic.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <vector>

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

bool may_be_degrees(Point point, bool latitude_first) {
  const double longitude = latitude_first ? point.y : point.x, latitude = latitude_first ? point.x : point.y;
  return std::fabs(longitude) <= 360 && std::fabs(latitude) <= 90;
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

}  // namespace

std::string geographic_remark(std::string_view header, std::span<const Point> points) {
  constexpr std::array<std::string_view, 4> longitudes{"lon", "long", "lng", "longitude"};
  constexpr std::array<std::string_view, 2> latitudes{"lat", "latitude"};
  constexpr std::size_t sample = 1000, enough = 16;
  constexpr double much_shorter = 30;  // degrees
  const std::vector<std::string> words = words_of(header);
  const std::size_t longitude = word_among(longitudes, words), latitude = word_among(latitudes, words);
  const bool named = longitude < words.size() && latitude < words.size(),
             latitude_first = named && latitude < longitude;
  const std::span<const Point> beginning = points.first(std::min(points.size(), sample));
  const auto fits = [&](Point point) { return may_be_degrees(point, latitude_first); };
  if (!named && (points.size() < enough || !std::all_of(beginning.begin(), beginning.end(), fits))) return {};
  if (!std::all_of(points.begin(), points.end(), fits)) return {};
  const Jumps jumps = jumps_in(points, latitude_first);
  const bool crosses = jumps.count > 0 && jumps.largest_other < much_shorter;
  if (!named && !crosses) return {};
  std::string text = named ? "has columns named " + words[std::min(longitude, latitude)] + " and " +
                                 words[std::max(longitude, latitude)] + ", which are taken as x and y in that order"
                           : "looks like longitudes and latitudes, which are taken as x and y";
  text += "; areas are those of the plane, in square degrees";
  if (crosses) {
    text += ", and its segment " + std::to_string(jumps.first) +
            " runs back across the whole map where the curve crosses the date line";
  }
  return text;
}

}  // namespace lober::detail
