// Whether fixed points fill a curve or an area, as those of an integrable map do.

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "engine/dynamics/fixed_points/newton.hpp"
#include "engine/dynamics/fixed_points/scan.hpp"

namespace lober::detail {
namespace {

double apart(Point a, Point b) {
  return length(a - b);
}

}  // namespace

bool fill_a_curve(const PlanarMap& map, const std::vector<FixedPoint>& points, const FixedPointOptions& options,
                  double cell) {
  constexpr std::size_t min_pairs = 6, max_pairs = 16;
  std::vector<Point> degenerate;
  for (const FixedPoint& point : points) {
    if (index_of(point, options.period) == 0) degenerate.push_back(point.at);
  }
  // Neighbours about a cell apart: nearer ones may be one degenerate point, which Newton's method finds inexactly.
  std::vector<std::pair<Point, Point>> pairs;
  const std::size_t step = std::max<std::size_t>(1, degenerate.size() / max_pairs);
  for (std::size_t k = 0; k < degenerate.size() && pairs.size() < max_pairs; k += step) {
    std::optional<Point> nearest;
    for (const Point other : degenerate) {
      const double distance = apart(degenerate[k], other);
      if (distance < 0.25 * cell || distance > 4 * cell) continue;
      if (!nearest || distance < apart(degenerate[k], *nearest)) nearest = other;
    }
    if (nearest) pairs.emplace_back(degenerate[k], *nearest);
  }
  if (pairs.size() < min_pairs) return false;
  std::vector<Point> between;
  between.reserve(pairs.size());
  for (const auto& [a, b] : pairs) between.push_back({0.5 * (a.x + b.x), 0.5 * (a.y + b.y)});
  const std::vector<NewtonEnd> ends = newton(map, between, options, cell, nullptr, true);
  std::size_t further = 0;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const double distance = apart(pairs[k].first, pairs[k].second), from_middle = apart(ends[k].at, between[k]);
    if (ends[k].converged && from_middle < 0.25 * distance) ++further;
  }
  return 4 * further >= 3 * pairs.size();
}

}  // namespace lober::detail
