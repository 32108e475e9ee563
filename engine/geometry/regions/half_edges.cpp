#include "engine/geometry/regions/half_edges.hpp"

#include <algorithm>
#include <atomic>
#include <span>
#include <vector>

#include "engine/base/parallel/parallel.hpp"

namespace lober::detail {
namespace {

constexpr std::size_t events_a_block = std::size_t{1} << 12;

// A half-edge with its direction: that of the way from one vertex to another.
struct DirectedEdge {
  Point from, to;
  std::uint32_t half;
};

DirectedEdge directed_edge(const EdgeChains& edge_chains, const Events& events, std::uint32_t half) {
  const Event& event = events.list[origin(events, half)];
  if (half % 2 == 0) {
    const auto [a, b] = edge_chains.segment(event.segment);
    return {a, b, half};
  }
  const bool at_start = event.kind == Event::Kind::at_start;
  const auto [a, b] = edge_chains.segment(at_start ? edge_chains.previous(event.segment) : event.segment);
  return {b, a, half};
}

// Compares by the angle from 0 (the direction of x) to 2 pi. Exact.
int compare_angles(const DirectedEdge& x, const DirectedEdge& y, PredicateCounts& counts) {
  const auto lower_half = [](const DirectedEdge& edge) {
    return edge.to.y < edge.from.y || (edge.to.y == edge.from.y && edge.to.x < edge.from.x);
  };
  const bool lower_x = lower_half(x), lower_y = lower_half(y);
  if (lower_x != lower_y) return lower_x ? 1 : -1;
  return -cross_sign(x.from, x.to, y.from, y.to, counts);
}

// Events by node.
struct EventsByNode {
  Buffer<std::uint32_t> begin, list;
  [[nodiscard]] std::span<const std::uint32_t> of(std::size_t node) const {
    return {list.data() + begin[node], begin[node + 1] - begin[node]};
  }
};

EventsByNode group(const Events& events) {
  EventsByNode result;
  result.begin.assign(events.nodes + std::size_t{1}, 0);
  for (const Event& event : events.list) ++result.begin[event.node + 1];
  for (std::size_t node = 0; node < events.nodes; ++node) result.begin[node + 1] += result.begin[node];
  result.list.resize(events.size());
  Buffer<std::uint32_t> next = result.begin;
  for (std::uint32_t event = 0; event < events.size(); ++event) result.list[next[events.list[event].node]++] = event;
  return result;
}

// Among coincident edges in one direction that of the lowest edge stays. Returns the number of edges merged away.
std::uint32_t merge_coincident(const Events& events, std::vector<DirectedEdge>& edges, HalfEdges& graph,
                               PredicateCounts& counts) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < edges.size();) {
    std::size_t end = k + 1;
    while (end < edges.size() && compare_angles(edges[k], edges[end], counts) == 0) ++end;
    const std::uint32_t first = edges[k].half;  // the lowest, as the sort left them
    // Both ends of the piece see the same group. The end from which its representative starts writes the result.
    if (end - k > 1 && first % 2 == 0) {
      Multiplicity sum{0, 0};
      for (std::size_t m = k; m < end; ++m) {
        const std::uint32_t half = edges[m].half;
        (half / 2 < events.begin[1] ? sum.of1 : sum.of2) += half % 2 == 0 ? 1 : -1;
        graph.stands_for[half / 2] = first ^ (half & 1U);
      }
      graph.multiplicity[first / 2] = sum;
    }
    edges[kept++] = edges[k];
    k = end;
  }
  const auto merged = static_cast<std::uint32_t>(edges.size() - kept);
  edges.resize(kept);
  return merged;
}

}  // namespace

HalfEdges connect(const EdgeChains& edge_chains, const Events& events) {
  HalfEdges graph;
  const std::uint32_t edges = events.size();
  graph.clockwise.resize(2 * std::size_t{edges});
  graph.stands_for.resize(edges);
  graph.multiplicity.resize(edges);
  for (std::uint32_t edge = 0; edge < edges; ++edge) {
    graph.stands_for[edge] = 2 * edge;
    graph.multiplicity[edge] = edge < events.begin[1] ? Multiplicity{1, 0} : Multiplicity{0, 1};
  }
  const EventsByNode by_node = group(events);
  std::array<std::uint32_t, 2> extreme_node{};
  for (std::size_t curve = 0; curve < 2; ++curve) extreme_node[curve] = events.list[events.extreme[curve]].node;

  std::atomic<std::uint32_t> merged{0};
  std::vector<PredicateCounts> counts((events.nodes + events_a_block - 1) / events_a_block);
  for_each_block(events.nodes, events_a_block, [&](std::size_t begin, std::size_t end) {
    PredicateCounts& here = counts[begin / events_a_block];
    std::uint32_t merged_here = 0;
    std::vector<DirectedEdge> leaving;
    for (std::size_t node = begin; node < end; ++node) {
      leaving.clear();
      for (const std::uint32_t event : by_node.of(node)) {
        leaving.push_back(directed_edge(edge_chains, events, 2 * event));
        leaving.push_back(directed_edge(edge_chains, events, 2 * events.previous(event) + 1));
      }
      std::sort(leaving.begin(), leaving.end(), [&](const DirectedEdge& x, const DirectedEdge& y) {
        const int order = compare_angles(x, y, here);
        return order != 0 ? order < 0 : x.half < y.half;
      });
      merged_here += merge_coincident(events, leaving, graph, here);
      for (std::size_t k = 0; k < leaving.size(); ++k) {
        graph.clockwise[leaving[k].half] = leaving[k == 0 ? leaving.size() - 1 : k - 1].half;
      }
      // None of its own edges leaves an extreme vertex in the direction of x, which lies before the first and after the
      // last.
      for (std::size_t curve = 0; curve < 2; ++curve) {
        if (extreme_node[curve] == node) graph.outer[curve] = leaving.back().half;
      }
    }
    merged += merged_here;
  });
  graph.merged = merged / 2;  // each was seen at both its ends
  for (const PredicateCounts& block : counts) graph.predicates += block;
  return graph;
}

}  // namespace lober::detail
