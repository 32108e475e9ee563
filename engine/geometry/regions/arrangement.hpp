// Everything known about the arrangement of one or two curves (private to regions/).
#pragma once

#include "engine/geometry/regions/faces.hpp"
#include "lober/overlay/regions.hpp"

namespace lober::detail {

struct Arrangement {
  EdgeChains edge_chains;
  Events events;
  HalfEdges graph;
  RegionFaces faces;
  int area_exponent = 0;  ///< areas are those of curves scaled by 2^-(area_exponent / 2)
  double lost = 0;        ///< bound on the error of any area before it is rounded to double

  [[nodiscard]] double area(DD twice) const;
  [[nodiscard]] Point node_point(std::uint32_t node) const { return point_of(edge_chains, events[node]); }

  std::vector<WindingArea> table;
  Buffer<DD> twice_areas;  ///< areas of the table
  std::array<double, 2> signed_areas{};
  RegionCounts counts;
  RegionTiming timing;
  std::array<std::shared_ptr<const void>, 2> owners;  ///< owners of the curves' points
};

struct RegionPiecesData {
  std::shared_ptr<const Arrangement> arrangement;
  Buffer<double> areas;
  Buffer<std::uint32_t> first_loop;  ///< first loop of each piece
  Buffer<std::uint32_t> first_half;  ///< first half-edge of each loop
  Buffer<std::uint32_t> halves;      ///< half-edges with the piece on the left
};

/// Whether a point with these winding numbers belongs to the region.
[[nodiscard]] bool belongs(Windings windings, FillRule rule, Pairing pairing);

}  // namespace lober::detail
