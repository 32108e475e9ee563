// On which arcs between pips the crossings lie.

#include "engine/geometry/crossings/crossings_data.hpp"
#include "engine/geometry/tangle/lobe_topology.hpp"

namespace lober {
using namespace detail;

std::vector<ArcsAt> arcs_at_nodes(const Tangle& tangle) {
  const NodeGraph& graph = graph_of(tangle.nodes);
  const auto count = static_cast<std::uint32_t>(tangle.pips.size());
  std::vector<ArcsAt> arcs(graph.size());
  std::uint32_t passed = 0;  // pips, along U
  for (std::uint32_t node = 0; node < graph.size(); ++node) {
    if (passed < count && tangle.pips[passed].node == node) ++passed;
    arcs[node].u = static_cast<std::int32_t>(passed) - 1;
  }
  std::uint32_t ahead = count;  // pips, along S, where they come the other way round
  for (const std::uint32_t node : graph.along2()) {
    if (ahead > 0 && tangle.pips[ahead - 1].node == node) {
      --ahead;
      arcs[node].s = static_cast<std::int32_t>(ahead);
    } else {
      arcs[node].s = static_cast<std::int32_t>(ahead) - 1;
    }
  }
  return arcs;
}

void detail::mark_pinched_lobes(Tangle& tangle) {
  const std::vector<ArcsAt> arcs = arcs_at_nodes(tangle);
  const auto lobes = static_cast<std::int32_t>(tangle.lobes.size());
  for (std::uint32_t node = 0; node < arcs.size(); ++node) {
    const ArcsAt at = arcs[node];
    if (tangle.nodes.rho(node) != 0 || at.u != at.s || at.u < 0 || at.u >= lobes) continue;
    tangle.lobes[static_cast<std::size_t>(at.u)].simple = false;
  }
}

}  // namespace lober
