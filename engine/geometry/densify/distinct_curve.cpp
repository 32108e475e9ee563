#include "engine/geometry/densify/distinct_curve.hpp"

#include "engine/base/parallel/running_sums.hpp"

namespace lober::detail {

DistinctCurve::DistinctCurve(CurveView curve) : view_(curve) {
  validate(curve, "the curve to densify");
  const std::span<const Point> points = curve.points;
  const auto repeats = [&](std::size_t k) {
    if (k == 0) return curve.closed && points.back() == points.front();
    return points[k] == points[k - 1];
  };
  if (sum_of(points.size(), [&](std::size_t k) { return repeats(k) ? 1 : 0; }) == 0) return;
  merged_ = gathered<Point>(
      points.size(), [&](std::size_t k) { return k == 0 || !repeats(k); }, [&](std::size_t k) { return points[k]; });
  // The first vertex stays the first, so of a closed curve it is the copy at the end that goes.
  while (curve.closed && merged_.back() == merged_.front()) merged_.pop_back();
  view_.points = merged_;
}

}  // namespace lober::detail
