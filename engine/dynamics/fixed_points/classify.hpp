// The kind of a fixed point by its derivative.
#pragma once

#include "lober/dynamics/fixed_points.hpp"

namespace lober::detail {

/// Fills in multipliers, directions and kind from the derivative.
void classify(FixedPoint& point);
/// The same where one of the multipliers is 1 as far as the derivative is known: it is made so, and the other one is
/// the determinant of the derivative.
void classify_degenerate(FixedPoint& point);

}  // namespace lober::detail
