// The contents of Crossings (private to geometry/).
#pragma once

#include <memory>
#include <utility>

#include "engine/geometry/crossings/node_graph.hpp"
#include "lober/overlay/crossings.hpp"

namespace lober::detail {

struct CrossingsData {
  NodeGraph graph;
  CurveView c1, c2;
  std::shared_ptr<const void> owner1, owner2;  // owners of their points
  int exponent = 0;                            // scaling exponent of both (curve/scaled.hpp)
  bool clockwise1 = false, clockwise2 = false;
  std::size_t crossings = 0, touches = 0, shared_arcs = 0;
};

[[nodiscard]] Crossings make_crossings(NodeGraph graph, const IndexedCurve& c1, const IndexedCurve& c2,
                                       Orientation orientation1, Orientation orientation2);
/// The same nodes on curves with the same vertices at another scale.
[[nodiscard]] Crossings moved_to(const Crossings& nodes, const IndexedCurve& c1, const IndexedCurve& c2);

[[nodiscard]] inline const NodeGraph& graph_of(const Crossings& nodes) {
  return nodes.data().graph;
}
/// The contact rounded to double: exact at a vertex, else right to about an ulp.
[[nodiscard]] inline Point contact_point(const Crossings& nodes, const Contact& contact) {
  return contact_point(contact, nodes.data().c1, nodes.data().c2);
}

}  // namespace lober::detail
