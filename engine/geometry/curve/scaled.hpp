// Coordinates so large or small that products of some of them leave the range of double are brought into it by a power
// of two first. Parameters along segments and all combinatorics stay as they are; areas are scaled back.
#pragma once

#include <vector>

#include "kernels/box.hpp"
#include "lober/areas.hpp"
#include "lober/curve.hpp"

namespace lober::detail {

/// The power of two by which the coordinates of a scene with this box have to be multiplied; 0 nearly always.
[[nodiscard]] int scaling_exponent(const Box& box);

/// The vertices times 2^exponent. Throws DataError when that is not exact: then coordinates range too widely for areas
/// in double. O(N).
[[nodiscard]] std::vector<Point> scaled(const CurveView& curve, int exponent);

/// The area times 2^exponent. Throws DataError when that is beyond the range of double.
[[nodiscard]] double scaled_area(double area, int exponent);

/// Multiplies each area by 2^exponent. Throws as `scaled_area` does.
void scale(Areas& areas, int exponent);

/// Multiplies each bound on the error of an area by 2^exponent and adds what the area may have lost to underflow when
/// it was scaled. No error of an area in the range of double is larger than the largest double, so no bound has to be.
void scale_bounds(Areas& bounds, int exponent);
[[nodiscard]] double scaled_bound(double bound, int exponent);

}  // namespace lober::detail
