// Where each stretch and each vertex of a curve lies with respect to the region of the other curve.
//
// Nothing is searched: sides change at nodes only, and there the order of the arms says to what.
//   label_vertices agrees with a point-in-polygon test of every vertex (exact, on the curve included).
#pragma once

#include <cstdint>
#include <vector>

#include "engine/crossings/crossings.hpp"

namespace lober {

enum class Side : std::uint8_t { outside, on, inside };

/// A place on a curve from which on it lies on another side of the other curve (or on the same one again,
/// after a touch).
struct SideChange {
  Position at;
  bool at_vertex;  ///< `at` is the first vertex of its segment
  Point point;
  Side side;  ///< of the stretch that follows
};

/// The changes of side of curve `curve` (1 or 2) in order along it, from its first vertex on, in the
/// direction of the input: one for each point where the curves meet, two for each shared arc. Empty when
/// there is no node. O(nodes).
[[nodiscard]] std::vector<SideChange> side_changes(const Crossings& nodes, int curve);

/// The label of each vertex of curve `curve` (1 or 2). O(N), or O(N log N) for one point query when there is
/// no node.
[[nodiscard]] std::vector<Side> label_vertices(const Crossings& nodes, int curve);

}  // namespace lober
