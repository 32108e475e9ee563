// All incidences of two segments, found exactly, once (private to regions/).
//
// Segments are half-open, with their first end and without their second, as in crossings/: so a point that two segments
// have in common belongs to exactly one pair for each two edge chains that pass through it, and consecutive segments
// have nothing in common unless the curve folds back. Where segments overlap, the ends of the overlap and all vertices
// in it are first ends of some segment, hence incidences too; in between there are none. Half-open segments do not show
// the end of a spike that runs back on itself; spikes are listed apart.
//
// At a vertex inside a run that two edge chains share, both come from one vertex and go on to one vertex: they keep
// together. That is an equivalence of the edge chains through a point. Where all of them keep together, nothing else is
// there and no spike ends, the vertex is like any other vertex of one edge chain and no node is needed; where there are
// two classes, each edge chain meets one of another class. So incidences of edge chains that keep together are left out
// of the list (but for those at the extreme vertices, which are nodes always), and what remains still joins all edge
// chains through each node. Boundaries that share a million vertices have few nodes.
//
// Where C1 and C2 share a run of vertices and neither meets itself there, nothing else can be found inside of the run:
// its vertices are counted as both curves are followed, and the search leaves it out, as in crossings/.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/geometry/index/index.hpp"
#include "engine/geometry/regions/edge_chains.hpp"
#include "kernels/double_double.hpp"
#include "kernels/predicates.hpp"
#include "lober/base/buffer.hpp"

namespace lober::detail {

struct Incidence {
  std::uint32_t first, second;  ///< segments, as EdgeChains number them
  std::int8_t rho;              ///< proper crossing: +1 if `second` passes from right to left of `first`, -1; else 0
  bool starts1, starts2;        ///< the point is the first end of the segment; for a proper crossing neither is true
};

struct IncidenceCounts {
  SearchCounts search;
  PredicateCounts predicates;
  std::uint64_t exact_parameters = 0;  ///< crossings too shallow for double-double
  /// Incidences of C1 and itself, C2 and itself, C1 and C2, those of edge chains that keep together included.
  std::uint64_t self1 = 0, self2 = 0, mutual = 0;
  std::uint64_t along = 0;  ///< vertices without a node where edge chains keep together
};

struct Incidences {
  Buffer<Incidence> list;  ///< those of C1 and itself, C2 and itself, C1 and C2
  /// On the first segment of each, and on the second: in [0, 1), zero at the segment's first end.
  std::array<Buffer<DD>, 2> parameters;
  std::array<std::size_t, 4> begin{};  ///< where the three parts of the list begin, and its size
  std::vector<std::uint32_t> spikes;   ///< segments whose first end is the end of a spike; one may occur twice
  IncidenceCounts counts;
};

/// Searches C1 against itself and, unless c2 is null, C2 against itself and C1 against C2 (with the index `kind`).
/// `extreme`: the segments whose first ends are the extreme vertices. O(N + candidates), parallel. The set found does
/// not depend on `kind`, its order does.
[[nodiscard]] Incidences find_incidences(const IndexedCurve& c1, const IndexedCurve* c2, IndexKind kind,
                                         std::array<std::uint32_t, 2> extreme);

}  // namespace lober::detail
