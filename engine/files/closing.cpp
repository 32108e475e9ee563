#include "engine/files/closing.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/base/text.hpp"
#include "lober/base/error.hpp"
#include "lober/curve/cylinders.hpp"

namespace lober::detail {
namespace {

double length(Point a, Point b) {
  return std::hypot(0.5 * b.x - 0.5 * a.x, 0.5 * b.y - 0.5 * a.y);  // half of it, which cannot overflow
}

}  // namespace

std::string closing_remark(std::span<const Point> points) {
  constexpr std::size_t sample = 4096;
  constexpr double much_longer = 10;
  if (points.size() < 4) return {};
  const std::size_t segments = points.size() - 1, step = (segments + sample - 1) / sample;
  std::vector<double> lengths;
  for (std::size_t k = 0; k < segments; k += step) {
    if (const double here = length(points[k], points[k + 1]); here > 0) lengths.push_back(here);
  }
  if (lengths.empty()) return {};
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  const double closing = length(points.back(), points.front());
  if (!(closing > much_longer * *middle)) return {};
  return "is not closed in its file; it was closed by a straight segment " +
         format_number(std::round(closing / *middle)) + " times as long as the median segment. Is it an open curve?";
}

}  // namespace lober::detail

namespace lober {
using namespace detail;

void require_closed_in_the_plane(std::span<const Point> points, Periods periods, const std::string& spec) {
  if (points.empty()) return;
  const auto check = [&](double first, double last, double period, const char* name) {
    if (period == 0 || std::fabs(last - first) <= 0.5 * period) return;
    throw DataError(spec + ": goes round the period of " + name + ", " + format_number(period) +
                    ", so that it is not closed in the plane; cut it open, or leave the period out");
  };
  check(points.front().x, points.back().x, periods.x, "x");
  check(points.front().y, points.back().y, periods.y, "y");
}

}  // namespace lober
