// How far a point that Newton's method ended at may be from the one that it was after.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/dynamics/fixed_points/newton.hpp"
#include "engine/dynamics/maps/plane.hpp"
#include "lober/dynamics/fixed_points.hpp"

namespace lober::detail {

/// Ends that are no further apart than that, relative to size_at, are the same point.
inline constexpr double same_place = 1e-6;

/// The direction in which D - 1 moves points least, or nearly so: across its longer row.
inline Point null_direction(const Matrix2& a) {
  const Point first{a.xx, a.xy}, second{a.yx, a.yy};
  const Point row = length(first) > length(second) ? first : second;
  const double norm = length(row);
  return norm > 0 ? Point{-row.y / norm, row.x / norm} : Point{1, 0};
}

/// Some of the steps that are left there, each of which comes nearer by a part only where the point is degenerate; at
/// most a thousandth of `size` (size_at).
inline double uncertainty(const FixedPoint& point, double size) {
  constexpr double steps = 4, most = 1e-3;
  const Matrix2 a = less_1(point.derivative);
  const double norm = norm_of(a);
  const double rounding = 4 * std::numeric_limits<double>::epsilon() * size;
  const double left = std::max(point.residual, rounding) * norm / std::abs(determinant(a));
  return std::min(most * size, steps * left);  // `most` where the derivative is 1: 0 / 0 compares as false
}

/// Whether two ends are the same point as far as either is known. `extent`: as FixedPointOptions says.
inline bool are_same(const FixedPoint& a, const FixedPoint& b, double extent) {
  const double size = size_within(extent, length(a.at)), apart = length(a.at - b.at);
  return apart <= same_place * size || apart <= uncertainty(a, size) + uncertainty(b, size);
}

}  // namespace lober::detail
