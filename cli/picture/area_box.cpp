#include "cli/picture/area_box.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "cli/picture/figure.hpp"

namespace lober::cli {
namespace {

constexpr std::size_t area_bins = 512;
constexpr double side_share = 0.01, worthwhile_share = 0.5;

struct Interval {
  double low, high;
};

// The interval of `along` that has all but the side_share of the area on either side. The signed area between an edge
// and the axis is divided among the area_bins that the edge passes.
Interval area_interval(std::span<const std::vector<Point>> polygons, Interval all, double Point::*along,
                       double Point::*across) {
  std::array<double, area_bins> sums{};
  const double width = (all.high - all.low) / static_cast<double>(area_bins);
  if (!(width > 0)) return all;
  for (const std::vector<Point>& polygon : polygons) {
    std::array<double, area_bins> own{};
    const double base = polygon.empty() ? 0 : polygon.front().*across;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Point& a = polygon[k];
      const Point& b = polygon[k + 1 < polygon.size() ? k + 1 : 0];
      const double from = (a.*along - all.low) / width, to = (b.*along - all.low) / width;
      const double low = std::min(from, to), high = std::max(from, to), sign = from < to ? 1 : -1;
      for (double bin = std::floor(low); bin <= high && high > low; ++bin) {
        const double first = std::max(low, bin), last = std::min(high, bin + 1);
        const double t = ((first + last) / 2 - from) / (to - from);
        const double height = a.*across - base + t * (b.*across - a.*across);
        own[static_cast<std::size_t>(std::clamp(bin, 0.0, area_bins - 1.0))] += sign * height * (last - first);
      }
    }
    for (std::size_t k = 0; k < area_bins; ++k) sums[k] += std::fabs(own[k]);
  }
  double total = 0;
  for (const double sum : sums) total += sum;
  std::size_t first = 0, last = area_bins - 1;
  for (double left = side_share * total; first < last && left >= sums[first]; ++first) left -= sums[first];
  for (double left = side_share * total; first < last && left >= sums[last]; --last) left -= sums[last];
  const Interval found{all.low + static_cast<double>(first) * width, all.low + static_cast<double>(last + 1) * width};
  return found.high - found.low < worthwhile_share * (all.high - all.low) ? found : all;
}

}  // namespace

Rectangle area_box(std::span<const std::vector<Point>> polygons) {
  Rectangle box;
  for (const std::vector<Point>& polygon : polygons) box = include(box, polygon);
  if (box.empty()) return box;
  const Interval x = area_interval(polygons, {box.min_x, box.max_x}, &Point::x, &Point::y);
  const Interval y = area_interval(polygons, {box.min_y, box.max_y}, &Point::y, &Point::x);
  return {x.low, y.low, x.high, y.high};
}

Rectangle box_about(const Rectangle& core, const Rectangle& box) {
  if (core.empty() || box.empty()) return box;
  const double x = core.max_x - core.min_x, y = core.max_y - core.min_y;
  return {std::min(core.min_x, std::max(box.min_x, core.min_x - x)),
          std::min(core.min_y, std::max(box.min_y, core.min_y - y)),
          std::max(core.max_x, std::min(box.max_x, core.max_x + x)),
          std::max(core.max_y, std::min(box.max_y, core.max_y + y))};
}

}  // namespace lober::cli
