// Where degenerate points are.
#pragma once

#include <span>

#include "lober/dynamics/fixed_points.hpp"

namespace lober::detail {

/// Puts degenerate points, of this very period, where they are: Newton's method ends within the square root of rounding
/// of one where two points meet, as it does not feel the displacement there any more, and within the cube root where
/// three do. There det(D - 1) is zero, or least, along the direction in which D - 1 vanishes, and is known far better.
/// Points where it says nothing stay, as those that fill a curve do, and those of flows, whose derivatives are less
/// exact.
void sharpen_degenerate(const PlanarMap& map, std::span<Point> at, const FixedPointOptions& options);

}  // namespace lober::detail
