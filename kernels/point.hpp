// The one geometric value that everything else is made of.
#pragma once

#include <cmath>

#include "kernels/inline.hpp"

namespace lober {

/// A point of the plane in the user's units. Layout is two packed doubles, so an array of points is an
/// N x 2 row-major matrix and can be mapped as one.
struct Point {
  double x = 0;
  double y = 0;
  friend constexpr bool operator==(const Point&, const Point&) = default;
};
static_assert(sizeof(Point) == 2 * sizeof(double));

/// Rounded; squares may overflow beyond 1e154.
[[nodiscard]] LOBER_INLINE double distance(Point a, Point b) {
  const double x = b.x - a.x, y = b.y - a.y;
  return std::sqrt(x * x + y * y);
}

}  // namespace lober
