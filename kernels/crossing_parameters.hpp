// The points where two segments cross properly: parameters on both, in double-double, eight crossings at a time.
#pragma once

#include <cstddef>

#include "kernels/double_double.hpp"
#include "kernels/point.hpp"

namespace lober::detail {

/// Segments a -> b and c -> d that cross properly.
struct SegmentCrossing {
  Point a, b, c, d;
};

/// Their parameters: the crossing is a + t1 (b - a) = c + t2 (d - c).
struct CrossingParameters {
  DD t1, t2;
};

/// The parameters are right to 2^-62 at least, and so well that the gap between the two points that they describe is
/// below 2^-91 `scale`, where `scale` is the size of the scene (gaps times distances are what areas lose). Crossings so
/// shallow that double-double cannot promise this are computed exactly (exact_parameter). Returns how many were.
std::size_t crossing_parameters(const SegmentCrossing* crossings, std::size_t count, double scale,
                                CrossingParameters* parameters);

/// Two parameters on one segment that differ by less may be in either order: ask compare_along.
inline constexpr double parameter_uncertainty = 0x1p-60;

}  // namespace lober::detail
