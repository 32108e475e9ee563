#include "engine/transport/curve_error.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace lober {
namespace {

// The largest distance across the curve between a vertex and where one step back towards the saddle and one step on
// lead. Of the step back what lies along the curve grows and what lies across it shrinks, so that the error of the step
// on remains.
double error_of_step(const PlanarMap& map, const LocalManifold& local, std::span<const Point> points) {
  constexpr std::size_t samples = 64;
  const std::size_t size = points.size();
  if (size < 3) return 0;
  const int outward = local.steps > 0 ? 1 : -1;
  double largest = 0;
  for (std::size_t k = 1; k <= samples; ++k) {
    const std::size_t at = 1 + (size - 3) * k / samples;
    Point there = points[at];
    map.iterate({&there, 1}, -outward);
    map.iterate({&there, 1}, outward);
    const Point along{points[at + 1].x - points[at - 1].x, points[at + 1].y - points[at - 1].y};
    const double length = std::hypot(along.x, along.y);
    const double across = (along.x * (there.y - points[at].y) - along.y * (there.x - points[at].x)) / length;
    if (std::isfinite(across)) largest = std::max(largest, std::fabs(across));
  }
  return largest;
}

}  // namespace

double curve_error(const PlanarMap& map, const ManifoldTangle& manifolds) {
  constexpr double safety = 4;  // 64 vertices are not all of them
  double sum = 0;
  const Pip& bip = manifolds.tangle.pips[manifolds.bip];
  for (const bool unstable : {true, false}) {
    const LocalManifold& local = unstable ? manifolds.local_u : manifolds.local_s;
    const GrownManifold& grown = unstable ? manifolds.u : manifolds.s;
    const std::size_t size = (unstable ? bip.u : bip.s).segment + std::size_t{1};
    const std::span<const Point> points = std::span<const Point>(grown.points).first(size);
    double scale = 0;
    for (const Point& point : points) scale = std::max({scale, std::fabs(point.x), std::fabs(point.y)});
    const double factor = std::fabs(local.multiplier);
    const double step = error_of_step(map, local, points) + 0x1p-53 * scale;
    sum = std::max(sum, safety * (step * factor / (factor - 1) + local.defect_across));
  }
  return sum;
}

}  // namespace lober
