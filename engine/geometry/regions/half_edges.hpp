// The planar graph between the nodes (private to regions/).
//
// Edge k is the part of the curve from event k to the next one. It has two half-edges: 2 k leaves event k onwards,
// 2 k + 1 leaves the next event back. Half-edges that leave a node in the same direction are the same straight piece,
// passed several times: one edge stands for all of them and carries how often each curve runs along it.
#pragma once

#include <array>
#include <cstdint>

#include "engine/geometry/regions/events.hpp"

namespace lober::detail {

struct Multiplicity {
  std::int32_t of1, of2;  ///< net, in the direction of the edge: what the winding numbers gain from right to left
};

struct HalfEdges {
  Buffer<std::uint32_t> clockwise;    ///< the next half-edge clockwise that leaves the same node; see stands_for
  Buffer<std::uint32_t> stands_for;   ///< for each edge, the half-edge that represents its half-edge 2 k; empty: itself
  Buffer<Multiplicity> merged_times;  ///< multiplicity of each edge that represents itself; empty with stands_for
  std::uint32_t second = 0;           ///< the first edge of C2
  std::array<std::uint32_t, 2>
      outer{};               ///< by curve: the half-edge at its extreme vertex with the direction of x on its left
  std::uint32_t merged = 0;  ///< edges that another one stands for
  PredicateCounts predicates;

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(clockwise.size()); }
  /// Whether the half-edge is one that represents itself.
  [[nodiscard]] bool stands(std::uint32_t half) const {
    return stands_for.empty() || stands_for[half / 2] == (half & ~1U);
  }
  /// The half-edge that stands for this one.
  [[nodiscard]] std::uint32_t representative(std::uint32_t half) const {
    return stands_for.empty() ? half : stands_for[half / 2] ^ (half & 1U);
  }
  /// The multiplicity of an edge that represents itself.
  [[nodiscard]] Multiplicity multiplicity(std::uint32_t edge) const {
    if (!merged_times.empty()) return merged_times[edge];
    return edge < second ? Multiplicity{1, 0} : Multiplicity{0, 1};
  }
  /// The half-edge that follows on the boundary of the face to the left.
  [[nodiscard]] std::uint32_t next(std::uint32_t half) const { return clockwise[half ^ 1U]; }
};

/// Sorts the half-edges round every node, exactly, and merges those that coincide. Where two edge chains cross and
/// nothing else is, the side to which one passes says all. O(events log degree), parallel.
[[nodiscard]] HalfEdges connect(const EdgeChains& edge_chains, const Events& events);

/// The event that a half-edge leaves.
[[nodiscard]] inline std::uint32_t origin(const Events& events, std::uint32_t half) {
  return half % 2 == 0 ? half / 2 : events.next(half / 2);
}

}  // namespace lober::detail
