// Many vertices of two curves located at once, each with respect to the other curve.
//
// A ray from one vertex says how often the other curve winds about it. From there on the number changes where the curve
// crosses the other one. One search finds the segments of both that may meet, and the sides on which their ends lie,
// decided anew for each pair, say what either number gains. No contact of the curves is used, nor how half-edges are
// ordered there.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "engine/geometry/index/box_tree.hpp"
#include "engine/geometry/index/ray_crossings.hpp"
#include "lober/base/buffer.hpp"
#include "lober/overlay/index.hpp"

namespace lober::detail {

/// ray_crossings of these vertices of c1 in the tree of c2, and of these vertices of c2 in the tree of c1, given by
/// their numbers in ascending order; where a vertex is on the other curve, the number means nothing. Exact, parallel.
/// Takes about as long as a search for pairs if most leaves have a vertex; few vertices are located one by one.
[[nodiscard]] std::array<Buffer<RayCrossings>, 2> vertex_windings(
    const IndexedCurve& c1, const IndexedCurve& c2, std::array<std::span<const std::uint32_t>, 2> vertices);

}  // namespace lober::detail
