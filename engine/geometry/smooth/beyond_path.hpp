// Where smooth arcs lie beyond a path of straight lines although their polygon does not (private to smooth/).
#pragma once

#include <cstddef>
#include <span>

#include "engine/geometry/smooth/smooth_curve.hpp"
#include "kernels/point.hpp"

namespace lober::detail {

/// Twice the area, from above, between the path and those arcs of the first `segments` segments that cross it where the
/// polygon does not, or the other way round; beside the first and the last point of the path too, from where an arc may
/// begin on the other side of the path than its segment. An arc lies where it is fitted, or as far beside that as it
/// may be wrong. The path has two points or more, at the scale of the curve. O(segments + legs of the path times
/// log(segments) + pairs of a leg and an arc that come near).
[[nodiscard]] double twice_beyond_path(const SmoothCurve& curve, std::span<const Point> path, std::size_t segments);

}  // namespace lober::detail
