// What the derivative says about a fixed point.
#pragma once

#include "lober/fixed_points.hpp"

namespace lober::detail {

/// Fills in multipliers, directions and kind from the derivative.
void classify(FixedPoint& point);

}  // namespace lober::detail
