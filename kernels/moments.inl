// Body of moments_along (kernels/all.inl).
#pragma once

#include "kernels/moments.hpp"
#include "kernels/simd.hpp"

namespace lober::detail {
namespace {

struct LaneSum {
  Lanes high = splat(0), low = splat(0);
  LOBER_INLINE void add(BasicDD<Lanes> term) {
    const BasicDD<Lanes> sum = two_sum(high, term.hi);
    high = sum.hi;
    low += sum.lo + term.lo;
  }
};

// Adds up 4 * quarter segments: lane l takes the l-th quarter of them, so that four sums run side by side.
inline void add_quarters(const Point* points, std::size_t quarter, Point origin, double factor, LaneSum& area,
                         LaneSum& sum_x, LaneSum& sum_y) {
  const Lanes ox = splat(origin.x), oy = splat(origin.y), by_factor = splat(factor);
  const auto load_points = [&](std::size_t k, BasicDD<Lanes>& x, BasicDD<Lanes>& y) {
    const Point &a = points[k], &b = points[quarter + k], &c = points[2 * quarter + k], &d = points[3 * quarter + k];
    x = two_diff(Lanes{a.x, b.x, c.x, d.x} * by_factor, ox);
    y = two_diff(Lanes{a.y, b.y, c.y, d.y} * by_factor, oy);
  };
  BasicDD<Lanes> before_x, before_y;
  load_points(0, before_x, before_y);
  for (std::size_t k = 1; k <= quarter; ++k) {
    BasicDD<Lanes> here_x, here_y;
    load_points(k, here_x, here_y);
    const BasicDD<Lanes> term = cross(before_x, before_y, here_x, here_y);
    area.add(term);
    sum_x.add(term * (before_x + here_x));
    sum_y.add(term * (before_y + here_y));
    before_x = here_x;
    before_y = here_y;
  }
}

inline DD joined(const LaneSum& sum) {
  DD total;
  for (std::size_t l = 0; l < lanes; ++l) total += two_sum(sum.high[l], sum.low[l]);
  return total;
}

inline Moments moments_of_quarters(const Point* points, std::size_t quarter, Point origin, double factor) {
  LaneSum area, x, y;
  add_quarters(points, quarter, origin, factor, area, x, y);
  return {joined(area), joined(x), joined(y)};
}

}  // namespace
}  // namespace lober::detail
