// All incidences of two segments, found exactly, once (private to regions/).
//
// Segments are half-open, with their first end and without their second, as in crossings/: so a point that two segments
// have in common belongs to exactly one pair for each two edge chains that pass through it, and consecutive segments
// have nothing in common unless the curve folds back. Where segments overlap, the ends of the overlap and all vertices
// in it are first ends of some segment, hence incidences too; in between there are none. Half-open segments do not show
// the end of a spike that runs back on itself; spikes are listed apart.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/geometry/index/index.hpp"
#include "engine/geometry/regions/edge_chains.hpp"
#include "kernels/double_double.hpp"
#include "kernels/predicates.hpp"
#include "lober/base/buffer.hpp"

namespace lober::detail {

struct Incidence {
  DD t1, t2;                    ///< parameters in [0, 1) on the two segments
  std::uint32_t first, second;  ///< segments, as EdgeChains number them
  bool starts1, starts2;        ///< the point is the first end of the segment; if neither, it is a proper crossing
};

struct IncidenceCounts {
  SearchCounts search;
  PredicateCounts predicates;
  std::uint64_t exact_parameters = 0;              ///< crossings too shallow for double-double
  std::uint64_t self1 = 0, self2 = 0, mutual = 0;  ///< incidences of C1 and itself, C2 and itself, C1 and C2
};

struct Incidences {
  Buffer<Incidence> list;
  std::vector<std::uint32_t> spikes;  ///< segments whose first end is the end of a spike; one may occur twice
  IncidenceCounts counts;
};

/// Searches C1 against itself and, unless c2 is null, C2 against itself and C1 against C2 (with the index `kind`).
/// O(N + candidates), parallel. The set found does not depend on `kind`, its order does.
[[nodiscard]] Incidences find_incidences(const IndexedCurve& c1, const IndexedCurve* c2, IndexKind kind);

}  // namespace lober::detail
