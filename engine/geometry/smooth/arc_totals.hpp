// From arcs to regions (private to smooth/).
//
// Every arc between two nodes bounds two regions, on its left and on its right. Which ones the order of the arms at the
// node before it says: a walk of faces is not needed for totals.
#pragma once

#include "engine/geometry/crossings/node_graph.hpp"
#include "engine/geometry/smooth/bulges.hpp"
#include "lober/overlay.hpp"

namespace lober {

Bulge operator+(const Bulge& a, const Bulge& b);
Bulge operator-(const Bulge& a, const Bulge& b);  ///< areas; errors add up

/// Running sums of bulges up to each contact that is an end of a node, whole curves, and the sum of doubts.
struct ArcEnds {
  Buffer<Bulge> on1, on2;
  Bulge total1, total2;
  double doubt = 0;
};

/// By how much smooth regions exceed those of the polygons, twice.
struct RegionBulges {
  Bulge c1, c2, only1, only2, both, unite;
};

/// Curves that meet in nodes. A shared arc counts with the bulges of C1 on both curves.
[[nodiscard]] RegionBulges bulges_of_regions(const Crossings& nodes, const ArcEnds& ends);

/// Curves without nodes: apart, one inside the other, or one and the same (then C1 counts for both).
[[nodiscard]] RegionBulges bulges_apart(const Overlay& result, const Bulge& total1, const Bulge& total2);

/// The contacts by which C2 comes to a node and leaves it.
inline std::uint32_t enters2(const NodeSpan& span) {
  return span.direction < 0 ? span.last : span.first;
}
inline std::uint32_t leaves2(const NodeSpan& span) {
  return span.direction < 0 ? span.first : span.last;
}

}  // namespace lober
