// Shoelace sums of the arcs between nodes (private to overlay/).
//
// Twice the area of any loop is the sum, over its arcs, of cross(v_i - o, v_{i+1} - o) about one common origin o. Both
// curves carry double-double running sums of it to each contact: the leaves of the tree bring theirs along, so only
// leaves that hold a contact are read again. The contact itself enters as t times the term of its segment, with t in
// double-double, so that it is one and the same point on both curves to 2^-91 of the scene.
#pragma once

#include "engine/crossings/node_graph.hpp"
#include "engine/index/index.hpp"

namespace lober {

struct ArcSums {
  DD total1, total2;  ///< whole curves: twice the signed areas
  Buffer<DD> arc1;    ///< from node k to node k + 1 along C1
  Buffer<DD> arc2;    ///< from node along2[k] to node along2[k + 1] along C2
  Buffer<DD> via;     ///< along the shared arc of node k, as C1 runs; empty when all nodes are points
};

/// Turns running sums at contacts (sums1 in order along C1, sums2 along C2) into sums between nodes.
[[nodiscard]] ArcSums sums_between_nodes(const NodeGraph& graph, Buffer<DD> sums1, DD total1, Buffer<DD> sums2,
                                         DD total2);

/// O(contacts + leaves that hold one + n / 1024), parallel.
[[nodiscard]] ArcSums sum_arcs(const IndexedCurve& c1, const IndexedCurve& c2, const NodeGraph& graph);

}  // namespace lober
