// The gap D at crossings: twice the area that U sweeps up to a crossing minus twice that which S sweeps (private to
// tangle/).
#pragma once

#include <cstdint>
#include <span>

#include "engine/geometry/crossings/node_graph.hpp"
#include "engine/geometry/tangle/curves.hpp"
#include "lober/base/buffer.hpp"

namespace lober::detail {

/// D at the given nodes, which must ascend, about the first vertex of U, in double-double; of the polygons. O(given +
/// leaves that hold one + (N + M) / 1024) + nodes.
[[nodiscard]] Buffer<DD> polygon_gaps_at(const TangleCurves& curves, const NodeGraph& graph,
                                         std::span<const std::uint32_t> nodes);

/// The same of other open curves, and about another origin.
[[nodiscard]] Buffer<DD> polygon_gaps_at(const IndexedCurve& u, const IndexedCurve& s, Point origin,
                                         const NodeGraph& graph, std::span<const std::uint32_t> nodes);

/// The gaps of the smooth curves if the tangle is made of them; then O(N + M).
[[nodiscard]] Buffer<DD> gaps_at(const TangleCurves& curves, const NodeGraph& graph,
                                 std::span<const std::uint32_t> nodes);

}  // namespace lober::detail
