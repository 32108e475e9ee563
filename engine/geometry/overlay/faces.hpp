// The faces of the arrangement of two curves that meet (private to overlay/).
//
// Two curves with at least one common point form a connected planar graph, so the boundary of each face is one closed
// walk. A walk that keeps its face on the left arrives at a node along one half-edge and goes on along the next
// half-edge clockwise: that is sigma of Naik, Lekien & Ross (2017, section 3) for crossings, and the right thing at
// touches and shared arcs too, where it keeps apart what only touches.
#pragma once

#include <array>
#include <cstdint>

#include "engine/geometry/crossings/node_graph.hpp"
#include "engine/geometry/overlay/arc_sums.hpp"
#include "lober/overlay/overlay.hpp"

namespace lober::detail {

/// The position of a point: inside A1, inside A2.
struct Membership {
  bool inside1, inside2;
  friend bool operator==(const Membership&, const Membership&) = default;
};

/// All faces of one membership. Face k has steps begin[k] .. begin[k + 1].
struct Faces {
  Buffer<double> area;  ///< signed: the unbounded face is negative
  Buffer<std::uint32_t> begin;
  Buffer<std::uint32_t> steps;  ///< see Step
  [[nodiscard]] std::size_t size() const { return area.size(); }
};

/// A step of a walk: the node that is passed and the curve (0: C1, 1: C2) of the arc that follows.
struct Step {
  std::uint32_t node;
  std::uint32_t curve;
};
inline constexpr std::uint32_t pack(Step step) {
  return step.node << 1 | step.curve;
}
inline constexpr Step unpack(std::uint32_t packed) {
  return {packed >> 1, packed & 1U};
}

/// The curves that run clockwise in the input.
struct Orientations {
  bool clockwise1, clockwise2;
};

/// Walks every face of the two memberships, each in order of their first nodes: two at a time, because what costs is
/// to bring the nodes from memory. Throws DataError when walks contradict each other, which they do on curves that are
/// not simple. O(nodes).
[[nodiscard]] std::array<Faces, 2> walk_faces(const NodeGraph& graph, const ArcSums& sums, Orientations orientations,
                                              const std::array<Membership, 2>& wanted);

/// Twice the total areas of all faces of a membership.
struct FaceTotals {
  DD only1, only2, both;
};

/// The totals without walking: each arc counts for the faces at its sides. O(nodes), parallel.
[[nodiscard]] FaceTotals total_of_faces(const NodeGraph& graph, const ArcSums& sums, Orientations orientations);

/// Throws the DataError that says so.
[[noreturn]] void fail_not_simple();

/// The number of the four sectors at a node that have this membership (0, 1 or 2).
[[nodiscard]] int sectors_at(std::uint8_t rotation, Orientations orientations, Membership wanted);

}  // namespace lober::detail
