#include "engine/dynamics/transport/turnstile/comparisons.hpp"

#include <string>

namespace lober::detail {
namespace {

std::string pair_text(const char* name, std::size_t i, std::size_t j, int n) {
  return name + std::to_string(i + 1) + std::to_string(j + 1) + "(" + std::to_string(n) + ")";
}

}  // namespace

void compare_routes(Agreement& agreement, const Partition& partition, const TransportStep& step) {
  const std::size_t regions = partition.size();
  for (std::size_t i = 0; i < regions; ++i) {
    for (std::size_t j = 0; j < regions; ++j) {
      const Measured lobes = step.total(i, j), boundaries = step.by_boundaries(i, j);
      agreement.compare({pair_text("T", i, j, step.n), "lobes", "boundaries", lobes.value, boundaries.value,
                         lobes.error + boundaries.error});
    }
    const Region& region = partition.regions()[i];
    if (!region.bounded) continue;
    // Species i is somewhere.
    Measured everywhere{}, change{};
    for (std::size_t j = 0; j < regions; ++j) {
      everywhere = everywhere + step.total(i, j);
      change = change + step.flux(i, j);
    }
    agreement.compare({"area of species " + std::to_string(i + 1) + " at n = " + std::to_string(step.n), "the region",
                       "the sum over regions", region.area.value, everywhere.value,
                       region.area.error + everywhere.error});
    if (regions == 2) {
      const Measured out = step.flux(0, 1), in = step.flux(1, 0);
      agreement.compare({"a(" + std::to_string(step.n) + ")", "what leaves R1", "what enters R1", out.value, in.value,
                         out.error + in.error});
    }
  }
}

void compare_particles(Agreement& agreement, const TransportStep& step) {
  for (std::size_t i = 0; i < step.total.size(); ++i) {
    for (std::size_t j = 0; j < step.total.size(); ++j) {
      const Measured lobes = step.total(i, j), particles = step.by_particles(i, j);
      agreement.compare({pair_text("T", i, j, step.n), "lobes", "particles", lobes.value, particles.value,
                         lobes.error + 5 * particles.error});
    }
  }
}

}  // namespace lober::detail
