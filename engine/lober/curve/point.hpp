// The two geometric values that everything else is made of.
#pragma once

#include <limits>

#include "lober/base/export.hpp"

namespace lober {

/// A point of the plane in the user's units. Layout is two packed doubles, so an array of points is an
/// N x 2 row-major matrix and can be mapped as one.
struct LOBER_API Point {
  double x = 0;  ///< the first coordinate
  double y = 0;  ///< the second coordinate
  /// Whether both coordinates are equal.
  friend constexpr bool operator==(const Point&, const Point&) = default;
};
static_assert(sizeof(Point) == 2 * sizeof(double));

/// A closed rectangle with sides along the axes; empty unless it is given bounds.
struct Rectangle {
  double min_x = std::numeric_limits<double>::infinity();   ///< the left side
  double min_y = std::numeric_limits<double>::infinity();   ///< the lower side
  double max_x = -std::numeric_limits<double>::infinity();  ///< the right side
  double max_y = -std::numeric_limits<double>::infinity();  ///< the upper side
  /// The rectangle with corners a and b.
  [[nodiscard]] static constexpr Rectangle of(Point a, Point b) {
    return {a.x < b.x ? a.x : b.x, a.y < b.y ? a.y : b.y, a.x < b.x ? b.x : a.x, a.y < b.y ? b.y : a.y};
  }
  /// Grows to hold the point.
  constexpr void add(Point point) {
    if (point.x < min_x) min_x = point.x;
    if (point.y < min_y) min_y = point.y;
    if (point.x > max_x) max_x = point.x;
    if (point.y > max_y) max_y = point.y;
  }
  /// Whether no point is in it.
  [[nodiscard]] constexpr bool empty() const { return !(min_x <= max_x && min_y <= max_y); }
  /// Whether the point is in it, or on its sides.
  [[nodiscard]] constexpr bool contains(Point point) const {
    return point.x >= min_x && point.x <= max_x && point.y >= min_y && point.y <= max_y;
  }
  /// The extent along x.
  [[nodiscard]] constexpr double width() const { return max_x - min_x; }
  /// The extent along y.
  [[nodiscard]] constexpr double height() const { return max_y - min_y; }
  /// Whether all four sides are equal.
  friend constexpr bool operator==(const Rectangle&, const Rectangle&) = default;
};

}  // namespace lober
