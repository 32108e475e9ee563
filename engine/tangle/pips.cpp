#include "engine/tangle/pips.hpp"

#include <limits>

namespace lober {

std::vector<std::uint32_t> find_pips(const Crossings& nodes) {
  const NodeGraph& graph = nodes.graph();
  std::vector<std::uint32_t> pips;
  std::uint32_t nearest = std::numeric_limits<std::uint32_t>::max();
  for (std::uint32_t node = 0; node < graph.size(); ++node) {
    if (graph.order[node] >= first_touch || graph.rank2[node] >= nearest) continue;
    nearest = graph.rank2[node];
    pips.push_back(node);
  }
  return pips;
}

}  // namespace lober
