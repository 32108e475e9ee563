// Areas of regions from those of arcs (private to smooth/).
//
// Every arc between two nodes bounds two regions, on its left and on its right. The order of the half-edges at the node
// before it says which ones: a walk of faces is not needed for totals. So each arc belongs to a class, and one pass
// along each curve adds up the chord-to-arc areas of its segments, class by class.
#pragma once

#include "engine/geometry/crossings/node_graph.hpp"
#include "engine/geometry/smooth/arc_boxes.hpp"
#include "engine/geometry/smooth/chord_areas.hpp"
#include "lober/overlay/overlay.hpp"

namespace lober::detail {

ChordArea operator+(const ChordArea& a, const ChordArea& b);
ChordArea operator-(const ChordArea& a, const ChordArea& b);  ///< areas; errors add up

/// The terms of each contact that is an end of a node: what it adds to the areas of the segments before it along either
/// curve (EndOfArcs), and the uncertainty there. All are zero elsewhere.
struct ArcEnds {
  Buffer<double> on1, on2, uncertainty;
};

/// Twice the areas by which smooth regions exceed those of the polygons.
struct RegionChordAreas {
  ChordArea c1, c2, only1, only2, both, union_;
  std::uint64_t straight = 0;  ///< segments of positive length that stay straight
};

/// A smooth curve with the boxes that the passes below fill in as they go.
struct CurveToAdd {
  const SmoothCurve& curve;
  ArcBoxes& boxes;
};

/// Curves that meet in nodes. A shared arc counts with the chord-to-arc areas of C1 on both curves. O(n + contacts),
/// parallel.
[[nodiscard]] RegionChordAreas chord_areas_of_regions(const Crossings& nodes, const ArcEnds& ends, CurveToAdd c1,
                                                      CurveToAdd c2);

/// Curves without nodes: apart, one inside the other, or one and the same (then C1 counts for both). O(n), parallel.
[[nodiscard]] RegionChordAreas chord_areas_apart(const Overlay& result, CurveToAdd c1, CurveToAdd c2);

/// The contacts by which C2 comes to a node and leaves it.
inline std::uint32_t enters2(const NodeSpan& span) {
  return span.direction < 0 ? span.last : span.first;
}
inline std::uint32_t leaves2(const NodeSpan& span) {
  return span.direction < 0 ? span.first : span.last;
}

}  // namespace lober::detail
