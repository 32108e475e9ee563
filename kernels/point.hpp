// The one geometric value that everything else is made of.
#pragma once

namespace lober {

/// A point of the plane in the user's units. Layout is two packed doubles, so an array of points is an
/// N x 2 row-major matrix and can be mapped as one.
struct Point {
  double x = 0;
  double y = 0;
  friend constexpr bool operator==(const Point&, const Point&) = default;
};
static_assert(sizeof(Point) == 2 * sizeof(double));

}  // namespace lober
