// The planar graph of two curves at the points where they meet: what overlay/ (and later tangle/) walk on.
//
// A node is a point or a shared arc, in either case a small disc out of which four half-edges lead: C1 onwards
// (forward1), C2 onwards (forward2), and the two ways back (backward1, backward2). Their cyclic order is all the
// geometry that is left at a node: it says whether the curves cross or touch, and on which side. Directions are those
// of the input.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "engine/geometry/crossings/contacts.hpp"

namespace lober::detail {

enum class HalfEdge : std::uint8_t { forward1, forward2, backward1, backward2 };
/// Tables with an entry for each half-edge have them in this order, sets of them are bits.
constexpr std::size_t index_of(HalfEdge half_edge) {
  return static_cast<std::size_t>(half_edge);
}
constexpr unsigned bit_of(HalfEdge half_edge) {
  return 1U << index_of(half_edge);
}
/// The first of a set that is not empty.
constexpr HalfEdge first_of(unsigned bits) {
  return static_cast<HalfEdge>(std::countr_zero(bits));
}

/// The half-edges counter-clockwise from forward1. The six possible orders; a node stores its number.
constexpr std::array<std::array<HalfEdge, 4>, 6> make_rotations() {
  using enum HalfEdge;
  return {{
      {forward1, forward2, backward1,
       backward2},  // a crossing, C2 from right to left: rho = +1, both counter-clockwise
      {forward1, backward2, backward1, forward2},  // a crossing, C2 from left to right: rho = -1
      {forward1, forward2, backward2, backward1},  // a touch, C2 on the left of C1 (two ways)
      {forward1, backward2, forward2, backward1},
      {forward1, backward1, forward2, backward2},  // a touch, C2 on the right of C1 (two ways)
      {forward1, backward1, backward2, forward2},
  }};
}
inline constexpr std::array<std::array<HalfEdge, 4>, 6> rotations = make_rotations();
enum RotationSystem : std::uint8_t { rightward_to_left = 0, leftward_to_right = 1, first_touch = 2 };

/// First and last contact of a node along C1. `direction` is 0 for a point, else how C2 runs along the shared arc
/// compared with C1, as the input runs.
struct NodeSpan {
  std::uint32_t first;
  std::uint32_t last;
  std::int8_t direction;
};

struct NodeGraph {
  ContactList contacts;             ///< in order along C1
  Buffer<NodeSpan> spans;           ///< in order along C1; empty when every node is the contact of the same number
  Buffer<std::uint8_t> order;       ///< RotationSystem of each node
  Buffer<std::uint32_t> contacts2;  ///< contact numbers in order along C2
  Buffer<std::uint32_t> nodes2;     ///< node numbers in order along C2; empty when `spans` is: then see along2()
  Buffer<std::uint32_t> rank2;      ///< index of each node in along2()
  std::int8_t same_curve = 0;  ///< +1 / -1: the two curves are one and the same, run in the same / opposite direction
  ContactCounts counts;
  double search_seconds = 0, order_seconds = 0;

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(order.size()); }
  [[nodiscard]] const Buffer<std::uint32_t>& along2() const { return spans.empty() ? contacts2 : nodes2; }
  [[nodiscard]] NodeSpan span(std::uint32_t node) const {
    return spans.empty() ? NodeSpan{node, node, 0} : spans[node];
  }
};

/// Finds all contacts and joins them to nodes. O(n + m + candidates), parallel where it is long.
[[nodiscard]] NodeGraph build_node_graph(const IndexedCurve& c1, const IndexedCurve& c2, IndexKind kind);

}  // namespace lober::detail
