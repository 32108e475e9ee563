// Directions around a contact (private to crossings/).
#pragma once

#include "engine/geometry/crossings/contacts.hpp"
#include "engine/geometry/crossings/node_graph.hpp"

namespace lober::detail {

/// The directions of the half-edges of a contact: `at` is the contact, the others are points further along the
/// half-edges. All are vertices of the input, except `at` of a proper crossing, which has no need of them. A half-edge
/// that an open curve does not have, because it begins or ends here, leads to `at` itself.
struct NodeHalfEdges {
  Point at;
  Point target[4];  // indexed by HalfEdge
};
[[nodiscard]] NodeHalfEdges half_edges_of(const Contact& contact, const CurveView& c1, const CurveView& c2);

/// Whether, turning counter-clockwise about `at` from the direction of `from`, the direction of x comes before that of
/// y. Exact. None of the three directions may be equal.
[[nodiscard]] bool turns_first(Point at, Point from, Point x, Point y, PredicateCounts& counts);

/// The order of the half-edges at a contact that is a node of its own. Where an open curve begins or ends, or runs
/// along the other one until it ends, nothing crosses: `first_touch`.
[[nodiscard]] std::uint8_t rotation_at_point(const Contact& contact, const CurveView& c1, const CurveView& c2,
                                             PredicateCounts& counts);

/// The order of the half-edges around an arc that is shared from contact `first` to contact `last` (along C1), with C2
/// running in `direction`.
[[nodiscard]] std::uint8_t rotation_at_arc(const Contact& first, const Contact& last, int direction,
                                           const CurveView& c1, const CurveView& c2, PredicateCounts& counts);

/// The next vertex in the direction +1 / -1 that is another point than `vertex`; `vertex` itself if there is
/// none.
[[nodiscard]] std::uint32_t next_distinct(const CurveView& curve, std::uint32_t vertex, int direction);

}  // namespace lober::detail
