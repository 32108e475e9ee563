// How closed curves run, exactly.
#pragma once

#include <cstdint>

#include "engine/geometry/index/index.hpp"

namespace lober::detail {

/// The segment, of those with a length, that begins at the vertex of the curve greatest by x, then by y. About log N
/// unless many leaves reach the greatest x.
[[nodiscard]] std::uint32_t extreme_segment(const BoxTree& tree);

/// The orientation of a closed curve. Exact for every simple curve, however thin it is and whatever the range of its
/// coordinates: where the rounding of the shoelace sum might hide its sign, the turn at the extreme vertex decides. For
/// a curve that crosses itself, the sign of its area where that is beyond rounding. `degenerate` if a curve that is not
/// simple turns back at its extreme vertex. Throws UsageError for an open curve. O(N / 1024).
[[nodiscard]] Orientation orientation(const IndexedCurve& curve);
/// The same where twice the signed area is there already, a sum along the closed curve (sums_along.hpp) about a point
/// of a scene of that extent (Box::extent). O(1) unless rounding might hide the sign.
[[nodiscard]] Orientation orientation(const IndexedCurve& curve, DD twice_area, double extent);

}  // namespace lober::detail
