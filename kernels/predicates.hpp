// Exact geometric decisions on doubles: a floating-point filter first, exact arithmetic where it cannot tell.
//
// Right for every finite double, overflow and underflow of intermediate results included.
#pragma once

#include <cmath>
#include <cstdint>

#include "kernels/double_double.hpp"
#include "kernels/point.hpp"
#include "lober/overlay/counts.hpp"

namespace lober::detail {

/// Forward error of the filter of orient2d, relative to |left| + |right|. With u = 2^-53: each difference has relative
/// error u, each product one more, the final subtraction one more, so |error| <= (3 u + O(u^2)) (|left| + |right|); the
/// rest of the constant covers the rounding of the bound itself (Shewchuk 1997, section 4.4).
inline constexpr double orient2d_error = (3.0 + 32 * 0x1p-53) * 0x1p-53;
/// Below this the products may have lost bits to underflow (at most 2^-1074 each).
inline constexpr double orient2d_floor = 0x1p-1000;

int cross_sign_beyond_filter(Point a, Point b, Point c, Point d, PredicateCounts& counts);

/// The sign of the determinant |b - a, d - c|: +1 when turning from the direction a -> b to the direction c -> d takes
/// less than half a turn counter-clockwise, -1 clockwise, 0 when they are parallel (or one has no length). Exact for
/// all finite points; the filter is that of orient2d, with the same number of roundings.
inline int cross_sign(Point a, Point b, Point c, Point d, PredicateCounts& counts) {
  const double left = (b.x - a.x) * (d.y - c.y);
  const double right = (b.y - a.y) * (d.x - c.x);
  const double determinant = left - right;
  const double bound = orient2d_error * (std::fabs(left) + std::fabs(right)) + orient2d_floor;
  if (determinant > bound) return 1;
  if (-determinant > bound) return -1;
  return cross_sign_beyond_filter(a, b, c, d, counts);
}

/// The side of the directed line a -> b on which c lies: +1 left, -1 right, 0 on the line (or a == b).
///   orient2d(a, b, c) == orient2d(b, c, a) == -orient2d(b, a, c) for all finite a, b, c.
/// About 3 ns when the filter decides; up to a microsecond when it does not.
inline int orient2d(Point a, Point b, Point c, PredicateCounts& counts) {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double determinant = left - right;
  const double bound = orient2d_error * (std::fabs(left) + std::fabs(right)) + orient2d_floor;
  if (determinant > bound) return 1;
  if (-determinant > bound) return -1;
  return cross_sign_beyond_filter(c, a, c, b, counts);
}

/// Whether p lies on the closed segment a b. Exact.
bool on_segment(Point a, Point b, Point p, PredicateCounts& counts);

/// The point where the line through c and d crosses segment a b properly (c, d strictly on both sides of line a b and
/// the other way round), or, when `vertex` is set, the point c itself, which lies on segment a b.
struct ImplicitPoint {
  Point c, d;
  bool vertex = false;
};

/// Order of two implicit points along the segment a -> b: -1 when p comes first, +1 when q does, 0 when they are the
/// same point. Exact; compares the ratios n/d of determinants of differences, polynomials of degree four.
int compare_along(Point a, Point b, const ImplicitPoint& p, const ImplicitPoint& q);

/// Parameter t of an implicit point on a -> b (point = a + t (b - a)), relative error at most 2^-96.
[[nodiscard]] DD exact_parameter(Point a, Point b, const ImplicitPoint& p);

}  // namespace lober::detail
