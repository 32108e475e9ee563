// The area of the intersection without geometry: no crossing is found, no point located, no face traced.
//
// The indicator of a simple polygon is the signed sum, over its edges, of the indicators of the trapezoids
// between the edge and a horizontal line below everything. So the area of A1 n A2 is the signed sum, over all
// pairs of edges, of the areas that their trapezoids have in common.
#pragma once

#include <span>

#include "kernels/point.hpp"
#include "tests/oracle/exact_number.hpp"

namespace lober::oracle {
using namespace lober::detail;

/// Exact area of A1 n A2 of two closed polygons of either orientation. O(n m).
[[nodiscard]] Rational trapezoid_intersection(std::span<const Point> first, std::span<const Point> second);

/// Exact signed area of one closed polygon: minus the integral of y dx.
[[nodiscard]] Rational trapezoid_area(std::span<const Point> points);

}  // namespace lober::oracle
