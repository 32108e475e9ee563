// The sums that the areas of faces are made of (private to overlay/).
//
// Twice the area of a loop is the sum of cross(v_i - o, v_{i+1} - o) along it, about one common origin o. Let S1 and S2
// be the running sums along C1 and C2 from their first vertices. On its way round a face a walk that changes between
// the curves at contacts collects S1 - S2 where it goes over from C1 to C2 and S2 - S1 where it comes back; everything
// else cancels, but for whole turns past a first vertex. So all that is kept is the *gap* S1 - S2 at each contact.
//
// The leaves of the tree bring their sums along, so only leaves that hold a contact are read again. The contact itself
// enters as t times the term of its segment, with t in double-double, so that it is one and the same point on both
// curves to 2^-91 of the scene.
#pragma once

#include "engine/geometry/crossings/node_graph.hpp"
#include "engine/geometry/index/index.hpp"

namespace lober::detail {

struct ArcSums {
  static constexpr std::uint32_t nowhere = 0xffffffff;

  DD total1, total2;  ///< whole curves: twice the signed areas
  Buffer<DD> gap;     ///< S1 - S2 at each contact, in order along C1
  /// Where the first vertices of the curves are passed: on the way from this node to the next along C1, from this index
  /// to the next along C2, inside the shared arc of this node (C1 only); nowhere if there is no such way.
  std::uint32_t wraps1 = nowhere, wraps2 = nowhere, wraps_inside = nowhere;
};

/// Fills in where the first vertices are.
void find_wraps(const NodeGraph& graph, ArcSums& sums);

/// O(contacts + leaves that hold one + n / 1024), parallel.
[[nodiscard]] ArcSums sum_arcs(const IndexedCurve& c1, const IndexedCurve& c2, const NodeGraph& graph);

}  // namespace lober::detail
