// Vectors and matrices of the plane.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernels/point.hpp"
#include "lober/dynamics/planar_map.hpp"

namespace lober::detail {

/// The value of a point whose orbit cannot be followed.
inline constexpr Point lost_point{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};

inline bool is_finite(Point point) {
  return std::isfinite(point.x) && std::isfinite(point.y);
}

/// The longer side of a region; infinite for an empty one, which says nothing of the unit of length.
inline double extent_of(const Rectangle& region) {
  const double extent = std::max(region.width(), region.height());
  return extent > 0 ? extent : std::numeric_limits<double>::infinity();
}

/// The length that errors and steps are relative to where coordinates have this size, in a region of this extent: a
/// unit of length may be far larger than all that lies in it.
inline double size_within(double extent, double size) {
  return std::min(1 + size, extent);
}

inline Matrix2 operator*(const Matrix2& a, const Matrix2& b) {
  return {a.xx * b.xx + a.xy * b.yx, a.xx * b.xy + a.xy * b.yy, a.yx * b.xx + a.yy * b.yx, a.yx * b.xy + a.yy * b.yy};
}

inline double determinant(const Matrix2& a) {
  return a.xx * a.yy - a.xy * a.yx;
}

/// The root of the sum of the squares of the entries.
inline double norm_of(const Matrix2& a) {
  return std::sqrt(a.xx * a.xx + a.xy * a.xy + a.yx * a.yx + a.yy * a.yy);
}

inline Matrix2 inverse(const Matrix2& a) {
  const double d = determinant(a);
  return {a.yy / d, -a.xy / d, -a.yx / d, a.xx / d};
}

}  // namespace lober::detail
