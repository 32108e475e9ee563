// Body of crossing_parameters (kernels/all.inl).
#pragma once

#include "kernels/crossing_parameters.hpp"
#include "kernels/simd.hpp"

namespace lober::detail {
namespace {

// Four crossings; bit k of the result is set when lane k is too shallow for double-double.
//
// A determinant of differences has error at most 12 u^2 m, m the sum of the sizes of its two products, u = 2^-53;
// dividing by the determinant D of the directions gives parameters with error below 2^-102 m / |D|. The gap is that
// times the lengths, so m / |D| times length / scale up to 2^10 keeps it below 2^-92 scale, and m / |D| up to 2^40
// keeps the parameters themselves right to 2^-62. If all differences are exact in double, as they are for curves that
// run close to each other, so are the products, and only their difference is rounded: to 2^-104 |D| + 2^-158 m. Then m
// / |D| up to 2^46 is good enough for both.
inline unsigned four_parameters(const SegmentCrossing* crossings, double scale, CrossingParameters* parameters) {
  Lanes first[lanes], second[lanes];
  for (std::size_t k = 0; k < lanes; ++k) {
    first[k] = load(&crossings[k].a.x);
    second[k] = load(&crossings[k].c.x);
  }
  transpose(first);
  transpose(second);
  const BasicDD<Lanes> ux = two_diff(first[2], first[0]), uy = two_diff(first[3], first[1]);
  const BasicDD<Lanes> vx = two_diff(second[2], second[0]), vy = two_diff(second[3], second[1]);
  const BasicDD<Lanes> wx = two_diff(second[0], first[0]), wy = two_diff(second[1], first[1]);
  const BasicDD<Lanes> below = cross(ux, uy, vx, vy);
  const BasicDD<Lanes> t1 = cross(wx, wy, vx, vy) / below;
  const BasicDD<Lanes> t2 = cross(wx, wy, ux, uy) / below;

  const Lanes u = max(absolute(ux.hi), absolute(uy.hi)), v = max(absolute(vx.hi), absolute(vy.hi));
  const Lanes w = max(absolute(wx.hi), absolute(wy.hi));
  const Lanes longest = max(u, v);
  const Lanes products = 2 * (max(u, w) * v + w * u);
  const Lanes determinant = absolute(below.hi);
  const Lanes rounded =
      absolute(ux.lo) + absolute(uy.lo) + absolute(vx.lo) + absolute(vy.lo) + absolute(wx.lo) + absolute(wy.lo);
  const LaneMask deep =
      (products * longest <= determinant * splat(0x1p10 * scale)) & (products <= determinant * 0x1p40);
  const LaneMask exact = (rounded == 0) & (products <= determinant * 0x1p46);
  const LaneMask good = (deep | exact) & (determinant > 0x1p-900) & (products < 0x1p900);

  Lanes rows[lanes] = {t1.hi, t1.lo, t2.hi, t2.lo};
  transpose(rows);
  for (std::size_t k = 0; k < lanes; ++k) store(&parameters[k].t1.hi, rows[k]);
  return ~mask_bits(good) & 15U;
}

}  // namespace
}  // namespace lober::detail
