// Body of crossing_parameters (kernels/all.inl).
#pragma once

#include "kernels/crossing_parameters.hpp"
#include "kernels/fours.inl"

namespace lober::detail {
namespace {

// As many crossings as there is room for; bit k of the result is set when number k is too shallow for double-double.
//
// A determinant of differences has error at most 12 u^2 m, m the sum of the sizes of its two products, u = 2^-53;
// dividing by the determinant D of the directions gives parameters with error below 2^-102 m / |D|. The gap is that
// times the lengths, so m / |D| times length / scale up to 2^10 keeps it below 2^-92 scale, and m / |D| up to 2^40
// keeps the parameters themselves right to 2^-62. If all differences are exact in double, as they are for curves that
// run close to each other, so are the products, and only their difference is rounded: to 2^-104 |D| + 2^-158 m. Then m
// / |D| up to 2^46 is good enough for both.
inline unsigned parameters_of(const SegmentCrossing* crossings, double scale, CrossingParameters* parameters) {
  Widest x[4], y[4];
  static_assert(sizeof(SegmentCrossing) == 8 * sizeof(double));
  load_fours(&crossings[0].a.x, x, y);
  const BasicDD<Widest> ux = two_diff(x[1], x[0]), uy = two_diff(y[1], y[0]);
  const BasicDD<Widest> vx = two_diff(x[3], x[2]), vy = two_diff(y[3], y[2]);
  const BasicDD<Widest> wx = two_diff(x[2], x[0]), wy = two_diff(y[2], y[0]);
  const BasicDD<Widest> below = cross(ux, uy, vx, vy);
  const BasicDD<Widest> t1 = cross(wx, wy, vx, vy) / below;
  const BasicDD<Widest> t2 = cross(wx, wy, ux, uy) / below;

  const Widest u = max(absolute(ux.hi), absolute(uy.hi)), v = max(absolute(vx.hi), absolute(vy.hi)),
               w = max(absolute(wx.hi), absolute(wy.hi));
  const Widest longest = max(u, v);
  const Widest products = 2 * (max(u, w) * v + w * u);
  const Widest determinant = absolute(below.hi);
  const Widest rounded =
      absolute(ux.lo) + absolute(uy.lo) + absolute(vx.lo) + absolute(vy.lo) + absolute(wx.lo) + absolute(wy.lo);
  const auto at_most_times = [&](Widest a, double factor) { return at_most(a, determinant * splat_widest(factor)); };
  const auto deep = both(at_most_times(products * longest, 0x1p10 * scale), at_most_times(products, 0x1p40));
  const auto exact = both(equal(rounded, splat_widest(0)), at_most_times(products, 0x1p46));
  const auto sound = both(less(splat_widest(0x1p-900), determinant), less(products, splat_widest(0x1p900)));

  const Widest columns[4] = {t1.hi, t1.lo, t2.hi, t2.lo};
  store_fours(columns, &parameters[0].t1.hi);
  return ~((mask_bits(deep) | mask_bits(exact)) & mask_bits(sound)) & ((1U << widest) - 1);
}

// Eight of them.
inline unsigned eight_parameters(const SegmentCrossing* crossings, double scale, CrossingParameters* parameters) {
  unsigned shallow = 0;
  for (std::size_t k = 0; k < eight; k += widest) {
    shallow |= parameters_of(crossings + k, scale, parameters + k) << k;
  }
  return shallow;
}

}  // namespace
}  // namespace lober::detail
