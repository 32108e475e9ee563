// The kind of a fixed point by its derivative.
#pragma once

#include "lober/dynamics/fixed_points.hpp"

namespace lober::detail {

/// Fills in multipliers, directions and kind from the derivative.
void classify(FixedPoint& point);

}  // namespace lober::detail
