// What of a closed polygon lies in a box.
#pragma once

#include <vector>

#include "engine/geometry/curve/curve.hpp"
#include "kernels/box.hpp"

namespace lober {

/// The polygon cut to the box, side by side (Sutherland & Hodgman 1974): parts that lie apart are joined along the
/// sides of the box by edges that run there and back, so that areas and winding numbers inside are right, for a polygon
/// that crosses itself too. Corners on the sides are rounded to double. O(N).
[[nodiscard]] std::vector<Point> clipped(const std::vector<Point>& polygon, const Box& box);

}  // namespace lober
