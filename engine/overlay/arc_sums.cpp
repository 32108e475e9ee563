#include "engine/overlay/arc_sums.hpp"

#include <algorithm>

#include "engine/index/sums_along.hpp"
#include "engine/parallel/parallel.hpp"

namespace lober {
namespace {

constexpr std::size_t node_grain = std::size_t{1} << 13;

// Turns sums at points into sums between them. Entering contact and leaving contact of node k, by number along the
// curve.
template <typename Enters, typename Leaves>
Buffer<DD> differences(const Buffer<DD>& sums, std::size_t nodes, DD total, const Enters& enters,
                       const Leaves& leaves) {
  Buffer<DD> arcs(nodes);
  for_each_block(nodes, node_grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const std::size_t from = leaves(k), to = enters(k + 1 == nodes ? 0 : k + 1);
      arcs[k] = sums[to] - sums[from];
      if (to <= from) arcs[k] += total;  // past the first vertex
    }
  });
  return arcs;
}

// The same in place, when every node is one contact.
void to_differences(Buffer<DD>& sums, DD total) {
  const std::size_t count = sums.size();
  if (count == 0) return;
  std::vector<DD> after((count + node_grain - 1) / node_grain);  // the sum that follows each block
  for (std::size_t k = 0; k < after.size(); ++k) {
    const std::size_t next = (k + 1) * node_grain;
    after[k] = next < count ? sums[next] : sums[0] + total;
  }
  for_each_block(count, node_grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k)
      sums[k] = (k + 1 < end ? sums[k + 1] : after[begin / node_grain]) - sums[k];
  });
}

}  // namespace

ArcSums sums_between_nodes(const NodeGraph& graph, Buffer<DD> sums1, DD total1, Buffer<DD> sums2, DD total2) {
  ArcSums result;
  result.total1 = total1;
  result.total2 = total2;
  const std::size_t count = graph.contacts.size(), nodes = graph.size();
  if (graph.spans.empty()) {
    result.arc1 = std::move(sums1);
    result.arc2 = std::move(sums2);
    run_together(
        nodes > node_grain, [&] { to_differences(result.arc1, result.total1); },
        [&] { to_differences(result.arc2, result.total2); });
    return result;
  }
  Buffer<std::uint32_t> place2(count);
  for (std::size_t k = 0; k < count; ++k) place2[graph.contacts2[k]] = static_cast<std::uint32_t>(k);
  result.arc1 = differences(
      sums1, nodes, result.total1, [&](std::size_t k) { return graph.spans[k].first; },
      [&](std::size_t k) { return graph.spans[k].last; });
  const Buffer<std::uint32_t>& along2 = graph.along2();
  result.arc2 = differences(
      sums2, nodes, result.total2,
      [&](std::size_t k) {
        const NodeSpan& span = graph.spans[along2[k]];
        return place2[span.direction < 0 ? span.last : span.first];
      },
      [&](std::size_t k) {
        const NodeSpan& span = graph.spans[along2[k]];
        return place2[span.direction < 0 ? span.first : span.last];
      });
  result.via.resize(nodes);
  for (std::size_t k = 0; k < nodes; ++k) {
    const NodeSpan& span = graph.spans[k];
    result.via[k] = sums1[span.last] - sums1[span.first];
    if (span.last < span.first) result.via[k] += result.total1;
  }
  return result;
}

ArcSums sum_arcs(const IndexedCurve& c1, const IndexedCurve& c2, const NodeGraph& graph) {
  const std::size_t count = graph.contacts.size();
  const Point origin = c1.view().points[0];
  SumsAlong first, second;
  run_together(
      count > node_grain,
      [&] {
        first = sums_along(c1.tree(), origin, count, [&](std::size_t k) {
          return PlaceAlong{graph.contacts[k].segment1, graph.contacts[k].t1};
        });
      },
      [&] {
        second = sums_along(c2.tree(), origin, count, [&](std::size_t k) {
          const Contact& contact = graph.contacts[graph.contacts2[k]];
          return PlaceAlong{contact.segment2, contact.t2};
        });
      });
  return sums_between_nodes(graph, std::move(first.at), first.total, std::move(second.at), second.total);
}

}  // namespace lober
