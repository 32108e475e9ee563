// Transport counted: particles put evenly into each bounded region, carried along by the map, and located exactly.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/dynamics/transport/turnstile/partition.hpp"
#include "lober/base/progress.hpp"
#include "lober/dynamics/planar_map.hpp"

namespace lober::detail {

struct ParticleOptions {
  std::uint64_t count = 0;  ///< in each bounded region
  std::uint64_t seed = 1;
  /// Called with the fraction done; return false to cancel.
  Progress progress{};
};

/// T_ij(n) for n = 1 ... iterates, with one standard deviation as error. For species from regions without an area,
/// particles of the others are carried backward; between two such regions NaN. Particle k of a region depends on the
/// seed, the region and k alone, so the counts are the same for any number of threads. A particle that is lost counts
/// as outside of every boundary. Throws Cancelled. Time: twice count * regions * iterates steps of the map, and as many
/// point locations for each boundary.
[[nodiscard]] std::vector<RegionMatrix> count_particles(const PlanarMap& map, std::span<const Barrier> barriers,
                                                        const Partition& partition, int iterates,
                                                        const ParticleOptions& options);

}  // namespace lober::detail
