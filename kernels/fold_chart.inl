// Body of chart_leaf (kernels/all.inl).
#pragma once

#include "kernels/fold_chart.hpp"
#include "kernels/leaf.hpp"
#include "kernels/simd.hpp"

namespace lober::detail {
namespace {

// How far the coordinates of an interval are from `at`, at most.
inline double farthest(double low, double high, double at) {
  const double below = __builtin_fabs(low - at), above = __builtin_fabs(high - at);
  return below < above ? above : below;
}

// Four points in the coordinates of a chart.
struct Charted {
  Lanes x, y, u, v, height;
};
inline void chart_points(Lanes x, Lanes y, const FoldChart& chart, Charted& at) {
  const Lanes ax = splat(chart.along.x), ay = splat(chart.along.y);
  at.x = x - splat(chart.at.x);
  at.y = y - splat(chart.at.y);
  at.u = ax * at.x + ay * at.y;
  at.v = ax * at.y - ay * at.x;
  at.height = at.v + (at.u * (splat(chart.slope) + splat(chart.bend) * at.u + splat(chart.shear) * at.v) +
                      splat(chart.bow) * at.v * at.v);
}
// The four numbers before these.
inline Lanes one_before(Lanes before, Lanes here) {
  return __builtin_shufflevector(before, here, 3, 4, 5, 6);
}

// Bounds over segments: of heights and u at their ends, of u^2 + v^2 from end to end, and of how far u grows.
struct SegmentBounds4 {
  Lanes low, high, left, right, square, least_rise, greatest_rise;
};

// Those of all segments that reach into the window; `whole` where all do. The rise is that of all segments.
template <bool whole>
inline void bound_segments(const Point* points, const Box& window, const FoldChart& chart, SegmentBounds4& bounds) {
  // Differences are rounded alike for the window: what meets it still does.
  const Lanes window_left = splat(window.min_x() - chart.at.x), window_right = splat(window.max_x() - chart.at.x);
  const Lanes window_bottom = splat(window.min_y() - chart.at.y), window_top = splat(window.max_y() - chart.at.y);
  const Lanes none = splat(__builtin_inf());
  bounds = {none, -none, none, -none, splat(0), none, -none};
  Charted before, here;
  chart_points(splat(points[0].x), splat(points[0].y), chart, before);
  if constexpr (whole) {
    bounds.low = bounds.high = before.height;
    bounds.left = bounds.right = before.u;
  }
  const double* const coordinates = &points[1].x;
  for (std::size_t i = 0; i < leaf_size; i += lanes) {
    const Lanes first = load(coordinates + 2 * i), second = load(coordinates + 2 * i + 4);
    chart_points(__builtin_shufflevector(first, second, 0, 2, 4, 6), __builtin_shufflevector(first, second, 1, 3, 5, 7),
                 chart, here);
    const Lanes u = one_before(before.u, here.u), rise = here.u - u, aside = here.v - one_before(before.v, here.v);
    const Lanes square = rise * rise + aside * aside;
    bounds.least_rise = min(bounds.least_rise, rise);
    bounds.greatest_rise = max(bounds.greatest_rise, rise);
    if constexpr (whole) {
      bounds.low = min(bounds.low, here.height);
      bounds.high = max(bounds.high, here.height);
      bounds.left = min(bounds.left, here.u);
      bounds.right = max(bounds.right, here.u);
      bounds.square = max(bounds.square, square);
    } else {
      const Lanes x = one_before(before.x, here.x), y = one_before(before.y, here.y);
      const Lanes height = one_before(before.height, here.height);
      const LaneMask in = (min(x, here.x) <= window_right) & (max(x, here.x) >= window_left) &
                          (min(y, here.y) <= window_top) & (max(y, here.y) >= window_bottom);
      bounds.low = min(bounds.low, in ? min(height, here.height) : none);
      bounds.high = max(bounds.high, in ? max(height, here.height) : -none);
      bounds.left = min(bounds.left, in ? min(u, here.u) : none);
      bounds.right = max(bounds.right, in ? max(u, here.u) : -none);
      bounds.square = max(bounds.square, in ? square : splat(0));
    }
    before = here;
  }
}

inline void chart_of_leaf(const Point* points, const Box& box, const Box& window, const FoldChart& chart,
                          ChartedLeaf& charted) {
  const double infinite = __builtin_inf();
  const double far = farthest(box.min_x(), box.max_x(), chart.at.x) + farthest(box.min_y(), box.max_y(), chart.at.y);
  const double quadratic = __builtin_fabs(chart.bend) + __builtin_fabs(chart.shear) + __builtin_fabs(chart.bow);
  // Numbers that could overflow, where minima and maxima say nothing, or a function too steep for the bounds below.
  if (!(far < 0x1p500 && quadratic < 0x1p400 && quadratic * far * far < 0x1p1000)) {
    charted = {-infinite, infinite, -infinite, infinite, true, false, false};
    return;
  }
  SegmentBounds4 bounds;
  if (box.min_x() >= window.min_x() && box.max_x() <= window.max_x() && box.min_y() >= window.min_y() &&
      box.max_y() <= window.max_y()) {
    bound_segments<true>(points, window, chart, bounds);
  } else {
    bound_segments<false>(points, window, chart, bounds);
  }
  // u and v have five roundings of numbers up to 1.5 far, heights ten more of numbers up to 8 far and 6 quadratic
  // far^2; products may underflow. Along a segment of length l a height is off that on the chord of its ends by at most
  // l^2 / 4 times what its quadratic part can be on the unit circle.
  const double slack_along = 0x1p-45 * far + 0x1p-1000;
  const double slack =
      0x1p-45 * (far + quadratic * far * far) + 0.2501 * quadratic * greatest(bounds.square) + 0x1p-600;
  const double low = least(bounds.low);
  charted.low = low - slack;
  charted.high = greatest(bounds.high) + slack;
  charted.left = least(bounds.left) - slack_along;
  charted.right = greatest(bounds.right) + slack_along;
  charted.is_inside = low < infinite;
  charted.rises = least(bounds.least_rise) > slack_along;
  charted.falls = greatest(bounds.greatest_rise) < -slack_along;
}

}  // namespace
}  // namespace lober::detail
