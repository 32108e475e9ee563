// Fixed and periodic points in a picture: each type by its symbol, with the sign of the multipliers of saddles.
#pragma once

#include <span>

#include "cli/picture/figure.hpp"
#include "lober/dynamics/fixed_points.hpp"

namespace lober::cli {

/// Appends a layer for each type and period, "2 saddles of period 3, \u03bb > 0" by their multipliers; where there are
/// saddles, short lines along which they repel and attract, a thirtieth of `box` long. With `labels` each point has its
/// residue.
void add_fixed_points(Figure& figure, std::span<const FixedPoint> points, const Rectangle& box, bool labels);

}  // namespace lober::cli
