// The faces of the arrangement with their winding numbers (private to regions/).
//
// Each curve is connected, so the graph has one component, or two when the curves do not meet. The boundary of a face
// is one closed walk, plus the outer walk of the other component if that lies inside the face.
#pragma once

#include <array>
#include <cstdint>

#include "engine/geometry/regions/half_edges.hpp"

namespace lober::detail {

struct Windings {
  std::int32_t of1, of2;
  // NOLINTNEXTLINE(modernize-use-nullptr): it means the literal 0 that the compiler generates
  friend auto operator<=>(const Windings&, const Windings&) = default;
};

/// How a face is reached from the unbounded one.
struct FaceLabel {
  Windings windings;    ///< winding numbers in the face
  std::uint32_t entry;  ///< a half-edge on its boundary; to the right of it lies a face of lower rank
  std::uint32_t rank;   ///< breadth-first order from the unbounded face
};

/// Shoelace sums of all edges about one origin, as differences of those from the first vertices of the curves on.
struct EdgeSums {
  std::array<Buffer<DD>, 2> up_to;  ///< by curve: each event, and its first one once more after a turn
  std::uint32_t second = 0;         ///< the first edge of C2

  [[nodiscard]] DD operator[](std::uint32_t edge) const {
    const DD* const sum = edge < second ? &up_to[0][edge] : &up_to[1][edge - second];
    return sum[1] - sum[0];
  }
};

struct RegionFaces {
  static constexpr std::uint32_t unbounded = 0;

  Buffer<std::uint32_t> of;  ///< the face to the left of each half-edge that stands for itself
  Buffer<DD> twice_area;     ///< twice the area of each face, meaningless for the unbounded one
  Buffer<FaceLabel> labels;  ///< one for each face

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(twice_area.size()); }
};

/// `curves_meet`: whether C1 and C2 have a point
/// in common. O(events), and one ray through the curves when they do not meet.
[[nodiscard]] RegionFaces make_faces(const EdgeChains& edge_chains, const Events& events, const HalfEdges& graph,
                                     const EdgeSums& sums, bool curves_meet, const IndexedCurve& c1,
                                     const IndexedCurve* c2, PredicateCounts& counts);

/// The answer where there is no half-edge.
inline constexpr std::uint32_t no_half_edge = 0xffffffff;
/// The first half-edge met by a ray from `point`, which does not lie on the curve, to greater x, on the side of greater
/// y when it runs through a vertex: the half-edge of curve `number` (0 or 1) that has the point on its left; or none.
[[nodiscard]] std::uint32_t half_edge_right_of(Point point, const EdgeChains& edge_chains, const Events& events,
                                               const HalfEdges& graph, const IndexedCurve& curve, int number,
                                               PredicateCounts& counts);

}  // namespace lober::detail
