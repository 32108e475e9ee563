#include "engine/geometry/densify/distinct_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/parallel/running_sums.hpp"
#include "engine/geometry/curve/scaled.hpp"

namespace lober::detail {

DistinctCurve::DistinctCurve(CurveView curve) : view_(curve) {
  validate(curve, "the curve to densify");
  const std::span<const Point> points = curve.points;
  const auto repeats = [&](std::size_t k) {
    if (k == 0) return curve.closed && points.back() == points.front();
    return points[k] == points[k - 1];
  };
  if (sum_of(points.size(), [&](std::size_t k) { return repeats(k) ? 1 : 0; }) > 0) {
    merged_ = gathered<Point>(
        points.size(), [&](std::size_t k) { return k == 0 || !repeats(k); }, [&](std::size_t k) { return points[k]; });
    // The first vertex stays the first, so of a closed curve it is the copy at the end that goes.
    while (curve.closed && merged_.back() == merged_.front()) merged_.pop_back();
    view_.points = merged_;
  }
  exponent_ = scaling_exponent(box_of(view_.points));
  if (exponent_ == 0) return;
  scaled_ = scaled(view_, exponent_);
  view_.points = scaled_;
}

double DistinctCurve::to_view(double length) const {
  if (exponent_ == 0 || !(length > 0)) return length;
  return std::max(std::ldexp(length, exponent_), std::numeric_limits<double>::denorm_min());
}

void DistinctCurve::from_view(Buffer<Point>& points) const {
  if (exponent_ == 0) return;
  for_each_block(points.size(), pass_grain, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k)
      points[k] = {std::ldexp(points[k].x, -exponent_), std::ldexp(points[k].y, -exponent_)};
  });
}

}  // namespace lober::detail
