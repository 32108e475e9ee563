#include "engine/geometry/regions/half_edges.hpp"

#include <algorithm>
#include <utility>
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
  const Event event = events[origin(events, half)];
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

// An edge and the half-edge that stands for its half-edge 2 k; a representative comes first, with what it carries.
struct MergedEdge {
  std::uint32_t edge, stands_for;
  Multiplicity times;
};

// Findings in a block of events besides the order round its nodes.
struct BlockFindings {
  std::vector<MergedEdge> merged;
  std::uint32_t merged_away = 0;  // half-edges
  PredicateCounts counts;
};

// Among coincident edges in one direction that of the lowest edge stays.
void merge_coincident(const Events& events, std::vector<DirectedEdge>& edges, BlockFindings& found) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < edges.size();) {
    std::size_t end = k + 1;
    while (end < edges.size() && compare_angles(edges[k], edges[end], found.counts) == 0) ++end;
    const std::uint32_t first = edges[k].half;  // the lowest, as the sort left them
    // Both ends of the piece see the same group. The end from which its representative starts tells of it.
    if (end - k > 1 && first % 2 == 0) {
      Multiplicity sum{0, 0};
      const std::size_t group = found.merged.size();
      for (std::size_t m = k; m < end; ++m) {
        const std::uint32_t half = edges[m].half;
        (half / 2 < events.begin[1] ? sum.of1 : sum.of2) += half % 2 == 0 ? 1 : -1;
        found.merged.push_back({half / 2, first ^ (half & 1U), {}});
      }
      found.merged[group].times = sum;
    }
    edges[kept++] = edges[k];
    k = end;
  }
  found.merged_away += static_cast<std::uint32_t>(edges.size() - kept);
  edges.resize(kept);
}

// The order round a node where two edge chains cross and nothing else is; `other` passes to the left of `one`, or to
// the right.
void connect_crossing(const Events& events, std::uint32_t one, std::uint32_t other, bool to_left, HalfEdges& graph) {
  if (!to_left) std::swap(one, other);
  // Counter-clockwise: onwards, the other one onwards, back, the other one back.
  const std::uint32_t on = 2 * one, back = 2 * events.previous(one) + 1;
  const std::uint32_t other_on = 2 * other, other_back = 2 * events.previous(other) + 1;
  graph.clockwise[on] = other_back;
  graph.clockwise[other_on] = on;
  graph.clockwise[back] = other_on;
  graph.clockwise[other_back] = back;
}

}  // namespace

HalfEdges connect(const EdgeChains& edge_chains, const Events& events) {
  HalfEdges graph;
  const std::uint32_t edges = events.size();
  graph.clockwise.resize(2 * std::size_t{edges});
  graph.second = events.begin[1];
  std::vector<BlockFindings> blocks((edges + events_a_block - 1) / events_a_block);
  for_each_block(edges, events_a_block, [&](std::size_t begin, std::size_t end) {
    BlockFindings& found = blocks[begin / events_a_block];
    std::vector<DirectedEdge> leaving;
    for (auto node = static_cast<std::uint32_t>(begin); node < end; ++node) {
      if (events.node[node] != node) continue;
      const std::uint32_t second = events.next_at_node[node];
      if (second != node && events.next_at_node[second] == node) {
        const Event event = events[node];
        if (event.kind == Event::Kind::at_crossing) {
          connect_crossing(events, node, second, event.rho > 0, graph);
          continue;
        }
      }
      leaving.clear();
      std::uint32_t event = node;
      do {
        leaving.push_back(directed_edge(edge_chains, events, 2 * event));
        leaving.push_back(directed_edge(edge_chains, events, 2 * events.previous(event) + 1));
        event = events.next_at_node[event];
      } while (event != node);
      std::sort(leaving.begin(), leaving.end(), [&](const DirectedEdge& x, const DirectedEdge& y) {
        const int order = compare_angles(x, y, found.counts);
        return order != 0 ? order < 0 : x.half < y.half;
      });
      merge_coincident(events, leaving, found);
      for (std::size_t k = 0; k < leaving.size(); ++k) {
        graph.clockwise[leaving[k].half] = leaving[k == 0 ? leaving.size() - 1 : k - 1].half;
      }
      // None of its own edges leaves an extreme vertex in the direction of x, which lies before the first and after the
      // last.
      for (std::size_t curve = 0; curve < 2; ++curve) {
        if (events.node[events.extreme[curve]] == node) graph.outer[curve] = leaving.back().half;
      }
    }
  });
  std::uint32_t merged_away = 0;
  bool any = false;
  for (const BlockFindings& block : blocks) {
    graph.predicates += block.counts;
    merged_away += block.merged_away;
    any = any || !block.merged.empty();
  }
  graph.merged = merged_away / 2;  // each was seen at both its ends
  if (!any) return graph;
  graph.merged_times.resize(edges);
  graph.stands_for.resize(edges);
  for (std::uint32_t edge = 0; edge < edges; ++edge) {
    graph.merged_times[edge] = edge < graph.second ? Multiplicity{1, 0} : Multiplicity{0, 1};
    graph.stands_for[edge] = 2 * edge;
  }
  for (const BlockFindings& block : blocks) {
    for (const MergedEdge& merged : block.merged) {
      graph.stands_for[merged.edge] = merged.stands_for;
      if (merged.stands_for == 2 * merged.edge) graph.merged_times[merged.edge] = merged.times;
    }
  }
  return graph;
}

}  // namespace lober::detail
