// Computations of the kernels with points.
#pragma once

#include <cmath>

#include "kernels/inline.hpp"
#include "lober/curve/point.hpp"

namespace lober::detail {

[[nodiscard]] LOBER_INLINE constexpr Point operator+(Point a, Point b) {
  return {a.x + b.x, a.y + b.y};
}
[[nodiscard]] LOBER_INLINE constexpr Point operator-(Point a, Point b) {
  return {a.x - b.x, a.y - b.y};
}
[[nodiscard]] LOBER_INLINE constexpr double dot(Point a, Point b) {
  return a.x * b.x + a.y * b.y;
}
/// Positive where b is to the left of a.
[[nodiscard]] LOBER_INLINE constexpr double cross(Point a, Point b) {
  return a.x * b.y - a.y * b.x;
}
/// Rounded; does not overflow.
[[nodiscard]] LOBER_INLINE double length(Point a) {
  return std::hypot(a.x, a.y);
}

/// Rounded; squares may overflow beyond 1e154.
[[nodiscard]] LOBER_INLINE double distance(Point a, Point b) {
  const double x = b.x - a.x, y = b.y - a.y;
  return std::sqrt(x * x + y * y);
}

}  // namespace lober::detail
