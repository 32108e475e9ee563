// Areas of regions from those of arcs (private to smooth/).
//
// Every arc between two nodes bounds two regions, on its left and on its right. The order of the half-edges at the node
// before it says which ones: a walk of faces is not needed for totals.
#pragma once

#include "engine/geometry/crossings/node_graph.hpp"
#include "engine/geometry/smooth/chord_areas.hpp"
#include "lober/overlay/overlay.hpp"

namespace lober::detail {

ChordArea operator+(const ChordArea& a, const ChordArea& b);
ChordArea operator-(const ChordArea& a, const ChordArea& b);  ///< areas; errors add up

/// Running sums of chord-to-arc areas up to each contact that is an end of a node, whole curves, and the sum of
/// uncertainties.
struct ArcEnds {
  Buffer<ChordArea> on1, on2;
  ChordArea total1, total2;
  double uncertainty = 0;
};

/// Twice the areas by which smooth regions exceed those of the polygons.
struct RegionChordAreas {
  ChordArea c1, c2, only1, only2, both, union_;
};

/// Curves that meet in nodes. A shared arc counts with the chord-to-arc areas of C1 on both curves.
[[nodiscard]] RegionChordAreas chord_areas_of_regions(const Crossings& nodes, const ArcEnds& ends);

/// Curves without nodes: apart, one inside the other, or one and the same (then C1 counts for both).
[[nodiscard]] RegionChordAreas chord_areas_apart(const Overlay& result, const ChordArea& total1,
                                                 const ChordArea& total2);

/// The contacts by which C2 comes to a node and leaves it.
inline std::uint32_t enters2(const NodeSpan& span) {
  return span.direction < 0 ? span.last : span.first;
}
inline std::uint32_t leaves2(const NodeSpan& span) {
  return span.direction < 0 ? span.first : span.last;
}

}  // namespace lober::detail
