#include "engine/geometry/tangle/pips.hpp"
#include "engine/geometry/crossings/crossings_data.hpp"

namespace lober::detail {

std::vector<std::uint32_t> find_pips(const Crossings& nodes, bool turn_u, bool turn_s) {
  const NodeGraph& graph = graph_of(nodes);
  const std::uint32_t count = graph.size();
  std::vector<std::uint32_t> pips;
  std::uint32_t nearest = count;
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::uint32_t node = turn_u ? count - 1 - k : k;
    const std::uint32_t rank = turn_s ? count - 1 - graph.rank2[node] : graph.rank2[node];
    if (graph.order[node] >= first_touch || rank >= nearest) continue;
    nearest = rank;
    pips.push_back(node);
  }
  return pips;
}

}  // namespace lober::detail
