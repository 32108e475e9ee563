// Coordinates so large or small that products of some of them leave the range of double are brought into it by a power
// of two first. Parameters along segments and all combinatorics stay as they are; areas are scaled back.
#pragma once

#include <vector>

#include "kernels/box.hpp"
#include "lober/curve/curve.hpp"
#include "lober/overlay/areas.hpp"

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
/// Throws DataError when nothing is known of an area (require_known); `areas` are scaled already.
void scale_bounds(const Areas& areas, Areas& bounds, int exponent);
[[nodiscard]] double scaled_bound(double bound, int exponent);

/// Throws DataError when an area came out as 0 and its bound, as `scaled_bound` gives it, is the largest double: the
/// area may be beyond that as well. So it is with a curve of 1e210 beside one of 1e300, as sums have a common origin.
void require_known(double area, double bound);

}  // namespace lober::detail
