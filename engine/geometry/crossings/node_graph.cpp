#include "engine/geometry/crossings/node_graph.hpp"

#include <algorithm>
#include <vector>

#include "engine/base/parallel/running_sums.hpp"
#include "engine/base/stopwatch.hpp"
#include "engine/geometry/crossings/rotation.hpp"

namespace lober::detail {
namespace {

// Whether `to` follows `from` along a curve in the given direction with no vertex strictly between, both given as
// (segment, at its first vertex).
struct Spot {
  std::uint32_t segment;
  bool at_vertex;
};
bool straight_forward(const CurveView& curve, Spot from, Spot to) {
  if (from.segment == to.segment) return !to.at_vertex;
  if (!to.at_vertex) return false;
  // Repeated vertices carry no segment: of several the last one counts.
  const auto size = static_cast<std::uint32_t>(curve.points.size());
  std::uint32_t vertex = from.segment + 1 == size ? 0 : from.segment + 1;
  const std::uint32_t begin = vertex;
  while (vertex != to.segment && curve.points[vertex] == curve.points[to.segment]) {
    vertex = vertex + 1 == size ? 0 : vertex + 1;
    if (vertex == begin) return false;
  }
  return vertex == to.segment;
}

class Joiner {
 public:
  Joiner(const CurveView& c1, const CurveView& c2, const ContactList& contacts, const Buffer<std::uint32_t>& order2)
      : c1_(c1), c2_(c2), contacts_(contacts), rank2_(contacts.size()), joined_(contacts.size()) {
    const auto count = static_cast<std::uint32_t>(contacts.size());
    for_each_block(count, pass_grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) rank2_[order2[k]] = static_cast<std::uint32_t>(k);
    });
    for_each_block(count, pass_grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) joined_[k] = direction_to_next(static_cast<std::uint32_t>(k));
    });
  }

  // +1 / -1 when the curves share the way from contact k to the next one along C1, C2 running onwards / back; else 0.
  [[nodiscard]] std::int8_t joined(std::uint32_t contact) const { return joined_[contact]; }

 private:
  [[nodiscard]] std::int8_t direction_to_next(std::uint32_t k) const {
    const Contact here = contacts_[k];
    if (here.run != 0 && c1_.closed && c2_.closed) return here.run;
    const auto count = static_cast<std::uint32_t>(contacts_.size());
    if (k + 1 == count && !c1_.closed) return 0;
    const std::uint32_t next = k + 1 == count ? 0 : k + 1;
    if (next == k) return 0;
    const Contact there = contacts_[next];
    // A run that an open curve ends has no contact at its end, so the next one is another.
    if (here.run != 0) {
      const std::uint32_t from = here.run > 0 ? rank2_[k] : rank2_[next], to = here.run > 0 ? rank2_[next] : rank2_[k];
      const bool neighbours = from + 1 == to || (c2_.closed && from + 1 == count && to == 0);
      return neighbours && there.vertex1 && there.vertex2 ? here.run : std::int8_t{0};
    }
    const Spot from1{here.segment1, here.vertex1}, to1{there.segment1, there.vertex1};
    if ((next == 0 && from1.segment == to1.segment) || !straight_forward(c1_, from1, to1)) return 0;
    const Spot from2{here.segment2, here.vertex2}, to2{there.segment2, there.vertex2};
    const std::uint32_t rank = rank2_[k], next_rank = rank2_[next];
    const auto follows = [&](std::uint32_t x, std::uint32_t y, Spot from, Spot to) {
      const bool wraps = x + 1 == count;
      if (wraps && !c2_.closed) return false;
      if (y != (wraps ? 0 : x + 1) || (wraps && from.segment == to.segment)) return false;
      return straight_forward(c2_, from, to);
    };
    if (follows(rank, next_rank, from2, to2)) return 1;
    if (follows(next_rank, rank, to2, from2)) return -1;
    return 0;
  }

  const CurveView &c1_, &c2_;
  const ContactList& contacts_;
  Buffer<std::uint32_t> rank2_;
  Buffer<std::int8_t> joined_;
};

// Joins contacts to nodes where there is anything to join: each begins where no shared way comes from before.
void find_spans(const Joiner& joiner, NodeGraph& graph) {
  const auto count = static_cast<std::uint32_t>(graph.contacts.size());
  const auto begins = [&](std::size_t contact) {
    return joiner.joined(contact == 0 ? count - 1 : static_cast<std::uint32_t>(contact - 1)) == 0;
  };
  graph.spans = gathered<NodeSpan>(count, begins, [&](std::size_t contact) {
    const auto first = static_cast<std::uint32_t>(contact);
    std::uint32_t last = first;
    while (joiner.joined(last) != 0) last = last + 1 == count ? 0 : last + 1;
    return NodeSpan{first, last, joiner.joined(first)};
  });
  if (graph.spans.empty() && count > 0) graph.same_curve = joiner.joined(0);  // all the way round
}

// The order of half-edges at each node.
void find_rotations(const CurveView& c1, const CurveView& c2, NodeGraph& graph) {
  const std::size_t nodes = graph.spans.size();
  graph.order.resize(nodes);
  std::vector<PredicateCounts> counts((nodes + pass_grain - 1) / pass_grain);
  for_each_block(nodes, pass_grain, [&](std::size_t begin, std::size_t end) {
    PredicateCounts here;
    for (std::size_t k = begin; k < end; ++k) {
      const NodeSpan& span = graph.spans[k];
      const Contact first = graph.contacts[span.first], last = graph.contacts[span.last];
      graph.order[k] = span.direction == 0 ? rotation_at_point(first, c1, c2, here)
                                           : rotation_at_arc(first, last, span.direction, c1, c2, here);
    }
    counts[begin / pass_grain] = here;
  });
  for (const PredicateCounts& here : counts) graph.counts.predicates += here;
}

// Nodes in the order along C2 of their first contacts.
void order_nodes_along_second(NodeGraph& graph) {
  constexpr std::uint32_t none = 0xffffffff;
  Buffer<std::uint32_t> node_of(graph.contacts.size());
  for_each_block(node_of.size(), pass_grain, [&](std::size_t begin, std::size_t end) {
    std::fill(node_of.begin() + begin, node_of.begin() + end, none);
  });
  for_each_block(graph.spans.size(), pass_grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) node_of[graph.spans[k].first] = static_cast<std::uint32_t>(k);
  });
  graph.nodes2 = gathered<std::uint32_t>(
      graph.contacts2.size(), [&](std::size_t k) { return node_of[graph.contacts2[k]] != none; },
      [&](std::size_t k) { return node_of[graph.contacts2[k]]; });
}

}  // namespace

NodeGraph build_node_graph(const IndexedCurve& c1, const IndexedCurve& c2, IndexKind kind) {
  Stopwatch watch;
  Contacts contacts = find_contacts(c1, c2, kind, watch);
  NodeGraph graph;
  graph.search_seconds = contacts.search_seconds;
  graph.counts = contacts.counts;
  graph.contacts = std::move(contacts.list);
  graph.contacts2 = std::move(contacts.order2);
  const std::size_t contact_count = graph.contacts.size();
  if (contacts.all_proper) {
    graph.order.resize(contact_count);
    for_each_block(contact_count, pass_grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        graph.order[k] = graph.contacts[k].rho > 0 ? rightward_to_left : leftward_to_right;
      }
    });
  } else {
    find_spans(Joiner(c1.view(), c2.view(), graph.contacts, graph.contacts2), graph);
    if (graph.same_curve != 0) {
      graph.order_seconds = contacts.order_seconds + watch.seconds();
      return graph;
    }
    find_rotations(c1.view(), c2.view(), graph);
    order_nodes_along_second(graph);
  }
  const Buffer<std::uint32_t>& along2 = graph.along2();
  graph.rank2.resize(along2.size());
  for_each_block(along2.size(), pass_grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) graph.rank2[along2[k]] = static_cast<std::uint32_t>(k);
  });
  graph.order_seconds = contacts.order_seconds + watch.seconds();
  return graph;
}

}  // namespace lober::detail
