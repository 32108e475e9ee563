// The numbers of one iterate by their several routes (private to transport/).
#pragma once

#include "engine/dynamics/transport/turnstile/partition.hpp"
#include "lober/base/agreement.hpp"
#include "lober/transport/transport.hpp"

namespace lober::detail {

/// T by lobes and by boundaries, the area of each species, and what leaves and enters a closed region.
void compare_routes(Agreement& agreement, const Partition& partition, const TransportStep& step);
/// T by lobes and by particles.
void compare_particles(Agreement& agreement, const TransportStep& step);

}  // namespace lober::detail
