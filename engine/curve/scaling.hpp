// Coordinates so large or small that products of four of them leave the range of double are brought into it by a power
// of two first. Parameters and combinatorics do not change; areas are scaled back.
#pragma once

#include <vector>

#include "engine/curve/curve.hpp"
#include "kernels/box.hpp"

namespace lober {

/// The exponent of the power of two by which coordinates within `box` have to be multiplied; 0 nearly always.
[[nodiscard]] int scaling_exponent(const Box& box);

/// The points of the curve times 2^exponent. Throws DataError when one of them cannot be had exactly. O(N).
[[nodiscard]] std::vector<Point> scaled_points(CurveView curve, int exponent);

}  // namespace lober
