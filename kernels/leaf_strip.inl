// Body of leaf_strip (kernels/all.inl).
#pragma once

#include "kernels/leaf.hpp"
#include "kernels/simd.hpp"
#include "kernels/strip_value.hpp"

namespace lober::detail {
namespace {

// Coordinates along and beside a direction.
struct Turned {
  Point at, along;
  [[nodiscard]] double u(Point p) const { return along.x * (p.x - at.x) + along.y * (p.y - at.y); }
  [[nodiscard]] double v(Point p) const { return along.x * (p.y - at.y) - along.y * (p.x - at.x); }
};

// Turns the direction to the tangent in the middle of the parabola through `from`, `at` and `to`, and returns its bend;
// 0 where there is none.
inline double fit_parabola(Point from, Point to, Turned& turned) {
  const double u0 = turned.u(from), u1 = turned.u(to);
  const double near0 = __builtin_fabs(u0), near1 = __builtin_fabs(u1);
  const double length = near0 < near1 ? near1 : near0, shorter = near0 < near1 ? near0 : near1;
  if (!(u0 * u1 < 0 && shorter > 0.1 * length)) return 0;
  const double slope0 = turned.v(from) / u0, slope1 = turned.v(to) / u1, bend = (slope1 - slope0) / (u1 - u0);
  const double slope = slope0 - bend * u0;
  if (!(__builtin_fabs(slope) < 1) || !(__builtin_fabs(bend) * length <= 0.9)) return 0;
  turned.along = {turned.along.x - slope * turned.along.y, turned.along.y + slope * turned.along.x};
  normalise(turned.along);
  return bend;
}

struct Extent {
  double low, high, far;  // bounds of v - bend u^2, and of |u|
};

inline void measure(const Point* points, const Turned& turned, double bend, Extent& extent) {
  const double* coordinates = &points[0].x;
  const Lanes ax = splat(turned.along.x), ay = splat(turned.along.y), x0 = splat(turned.at.x), y0 = splat(turned.at.y);
  alignas(32) double at[leaf_size + lanes];
  const double last = turned.u(points[leaf_size]), last_value = turned.v(points[leaf_size]) - bend * last * last;
  store(at + leaf_size, splat(last));
  Lanes low = splat(last_value), high = low, far = absolute(splat(last)), longest = splat(0), sum = high;
  for (std::size_t i = 0; i < leaf_size; i += lanes) {
    const Lanes first = load(coordinates + 2 * i), second = load(coordinates + 2 * i + 4);
    const Lanes x = __builtin_shufflevector(first, second, 0, 2, 4, 6) - x0;
    const Lanes y = __builtin_shufflevector(first, second, 1, 3, 5, 7) - y0;
    const Lanes u = ax * x + ay * y, value = (ax * y - ay * x) - splat(bend) * u * u;
    store(at + i, u);
    low = min(low, value);
    high = max(high, value);
    far = max(far, absolute(u));
    sum += value;
  }
  for (std::size_t i = 0; i < leaf_size; i += lanes) longest = max(longest, absolute(load(at + i + 1) - load(at + i)));
  // Segments are chords of the parabola.
  const double step = greatest(longest), sagitta = 0.25 * bend * step * step;
  const double doubt = 0 * (sum[0] + sum[1] + sum[2] + sum[3]);  // no number where there is one that is not finite
  extent = {doubt + least(low) + (sagitta < 0 ? sagitta : 0), greatest(high) + (sagitta > 0 ? sagitta : 0),
            greatest(far)};
}

inline void fit_strip(const Point* points, Strip& strip) {
  const Point from = points[0], at = points[leaf_size / 2], to = points[leaf_size];
  const Point first{at.x - from.x, at.y - from.y}, second{to.x - at.x, to.y - at.y};
  const double sense = first.x * second.x + first.y * second.y < 0 ? -1 : 1;
  Turned turned{at, {first.x + sense * second.x, first.y + sense * second.y}};
  normalise(turned.along);
  double bend = fit_parabola(from, to, turned);
  Extent extent{};
  measure(points, turned, bend, extent);
  if (bend != not_steep(bend, extent.far)) {
    bend = 0;
    measure(points, turned, bend, extent);
  }
  strip_between(turned.at, turned.along, bend, extent.low, extent.high, extent.far, strip);
}

}  // namespace
}  // namespace lober::detail
