#include "engine/geometry/regions/half_edges.hpp"

#include <algorithm>
#include <atomic>
#include <span>
#include <vector>

#include "engine/base/parallel/parallel.hpp"

namespace lober {
namespace {

constexpr std::size_t grain = std::size_t{1} << 12;

// A half-edge with its direction: that of the way from one vertex to another.
struct Arm {
  Point from, to;
  std::uint32_t half;
};

Arm arm_of(const Strands& strands, const Marks& marks, std::uint32_t half) {
  const Mark& mark = marks.list[origin(marks, half)];
  if (half % 2 == 0) {
    const auto [a, b] = strands.segment(mark.segment);
    return {a, b, half};
  }
  const bool at_start = mark.kind == Mark::Kind::at_start;
  const auto [a, b] = strands.segment(at_start ? strands.previous(mark.segment) : mark.segment);
  return {b, a, half};
}

// By angle from 0 (the direction of x) to 2 pi. Exact.
int compare_angles(const Arm& x, const Arm& y, PredicateCounts& counts) {
  const auto lower_half = [](const Arm& arm) {
    return arm.to.y < arm.from.y || (arm.to.y == arm.from.y && arm.to.x < arm.from.x);
  };
  const bool lower_x = lower_half(x), lower_y = lower_half(y);
  if (lower_x != lower_y) return lower_x ? 1 : -1;
  return -cross_sign(x.from, x.to, y.from, y.to, counts);
}

// Marks by node.
struct MarksByNode {
  Buffer<std::uint32_t> begin, list;
  [[nodiscard]] std::span<const std::uint32_t> of(std::size_t node) const {
    return {list.data() + begin[node], begin[node + 1] - begin[node]};
  }
};

MarksByNode group(const Marks& marks) {
  MarksByNode result;
  result.begin.assign(marks.nodes + std::size_t{1}, 0);
  for (const Mark& mark : marks.list) ++result.begin[mark.node + 1];
  for (std::size_t node = 0; node < marks.nodes; ++node) result.begin[node + 1] += result.begin[node];
  result.list.resize(marks.size());
  Buffer<std::uint32_t> next = result.begin;
  for (std::uint32_t mark = 0; mark < marks.size(); ++mark) result.list[next[marks.list[mark].node]++] = mark;
  return result;
}

// Of arms in one direction the one of the lowest edge stays. Returns how many were merged away.
std::uint32_t merge_coincident(const Marks& marks, std::vector<Arm>& arms, HalfEdges& graph, PredicateCounts& counts) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < arms.size();) {
    std::size_t end = k + 1;
    while (end < arms.size() && compare_angles(arms[k], arms[end], counts) == 0) ++end;
    const std::uint32_t first = arms[k].half;  // the lowest, as the sort left them
    // Both ends of the piece see the same group. The end from which its representative starts writes the result.
    if (end - k > 1 && first % 2 == 0) {
      Multiplicity sum{0, 0};
      for (std::size_t m = k; m < end; ++m) {
        const std::uint32_t half = arms[m].half;
        (half / 2 < marks.begin[1] ? sum.of1 : sum.of2) += half % 2 == 0 ? 1 : -1;
        graph.stands_for[half / 2] = first ^ (half & 1U);
      }
      graph.multiplicity[first / 2] = sum;
    }
    arms[kept++] = arms[k];
    k = end;
  }
  const auto merged = static_cast<std::uint32_t>(arms.size() - kept);
  arms.resize(kept);
  return merged;
}

}  // namespace

HalfEdges connect(const Strands& strands, const Marks& marks) {
  HalfEdges graph;
  const std::uint32_t edges = marks.size();
  graph.clockwise.resize(2 * std::size_t{edges});
  graph.stands_for.resize(edges);
  graph.multiplicity.resize(edges);
  for (std::uint32_t edge = 0; edge < edges; ++edge) {
    graph.stands_for[edge] = 2 * edge;
    graph.multiplicity[edge] = edge < marks.begin[1] ? Multiplicity{1, 0} : Multiplicity{0, 1};
  }
  const MarksByNode by_node = group(marks);
  std::array<std::uint32_t, 2> extreme_node{};
  for (std::size_t curve = 0; curve < 2; ++curve) extreme_node[curve] = marks.list[marks.extreme[curve]].node;

  std::atomic<std::uint32_t> merged{0};
  std::vector<PredicateCounts> counts((marks.nodes + grain - 1) / grain);
  for_each_block(marks.nodes, grain, [&](std::size_t begin, std::size_t end) {
    PredicateCounts& here = counts[begin / grain];
    std::uint32_t merged_here = 0;
    std::vector<Arm> arms;
    for (std::size_t node = begin; node < end; ++node) {
      arms.clear();
      for (const std::uint32_t mark : by_node.of(node)) {
        arms.push_back(arm_of(strands, marks, 2 * mark));
        arms.push_back(arm_of(strands, marks, 2 * marks.previous(mark) + 1));
      }
      std::sort(arms.begin(), arms.end(), [&](const Arm& x, const Arm& y) {
        const int order = compare_angles(x, y, here);
        return order != 0 ? order < 0 : x.half < y.half;
      });
      merged_here += merge_coincident(marks, arms, graph, here);
      for (std::size_t k = 0; k < arms.size(); ++k) {
        graph.clockwise[arms[k].half] = arms[k == 0 ? arms.size() - 1 : k - 1].half;
      }
      // None of its own arms leaves an extreme vertex in the direction of x, which lies before the first and after the
      // last.
      for (std::size_t curve = 0; curve < 2; ++curve) {
        if (extreme_node[curve] == node) graph.outer[curve] = arms.back().half;
      }
    }
    merged += merged_here;
  });
  graph.merged = merged / 2;  // each was seen at both its ends
  for (const PredicateCounts& block : counts) graph.predicates += block;
  return graph;
}

}  // namespace lober
