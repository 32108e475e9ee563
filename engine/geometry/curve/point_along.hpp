// Points inside segments.
#pragma once

#include "kernels/double_double.hpp"
#include "lober/curve/curve.hpp"

namespace lober::detail {

/// The point a + t (b - a) of a segment, 0 <= t <= 1, rounded to double: right to about an ulp, also where the segment
/// is longer than the largest double.
[[nodiscard]] Point point_along(const Segment& segment, DD t);

}  // namespace lober::detail
