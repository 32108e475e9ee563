#include "engine/geometry/overlay/arc_sums.hpp"

#include <algorithm>

#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/index/sums_along.hpp"

namespace lober::detail {
namespace {

// Right to 2^-104 of the larger one, which is far less than what the crossings lose (lost_in_sums); half the operations
// of DD - DD.
DD difference(DD a, DD b) {
  const DD high = two_diff(a.hi, b.hi);
  return two_sum(high.hi, high.lo + (a.lo - b.lo));
}

}  // namespace

void find_wraps(const NodeGraph& graph, ArcSums& sums) {
  const std::uint32_t nodes = graph.size();
  if (nodes == 0) return;
  if (graph.spans.empty()) {
    sums.wraps1 = sums.wraps2 = nodes - 1;
    return;
  }
  // A first vertex is passed where the next contact is not a later one.
  Buffer<std::uint32_t> index2(graph.contacts2.size());
  for (std::size_t k = 0; k < index2.size(); ++k) index2[graph.contacts2[k]] = static_cast<std::uint32_t>(k);
  const Buffer<std::uint32_t>& along2 = graph.along2();
  for (std::uint32_t k = 0; k < nodes; ++k) {
    const std::uint32_t next = k + 1 == nodes ? 0 : k + 1;
    const NodeSpan &here = graph.spans[k], &there = graph.spans[next];
    if (there.first <= here.last) sums.wraps1 = k;
    if (here.last < here.first) sums.wraps_inside = k;
    const NodeSpan &here2 = graph.spans[along2[k]], &there2 = graph.spans[along2[next]];
    const std::uint32_t leaves = here2.direction < 0 ? here2.first : here2.last;
    const std::uint32_t enters = there2.direction < 0 ? there2.last : there2.first;
    if (index2[enters] <= index2[leaves]) sums.wraps2 = k;
  }
}

ArcSums sum_arcs(const IndexedCurve& c1, const IndexedCurve& c2, const NodeGraph& graph) {
  const std::size_t count = graph.contacts.size();
  const Point origin = c1.view().points[0];
  ArcSums sums;
  sums.gap.resize(count);
  sums.total1 = sum_along(
                    c1.tree(), origin, count,
                    [&](std::size_t k) {
                      return PrecisePosition{graph.contacts[k].segment1, graph.contacts[k].t1};
                    },
                    [&](std::size_t k, DD sum) { sums.gap[k] = sum; })
                    .total;
  sums.total2 = sum_along(
                    c2.tree(), origin, count,
                    [&](std::size_t k) {
                      const Contact contact = graph.contacts[graph.contacts2[k]];
                      return PrecisePosition{contact.segment2, contact.t2};
                    },
                    [&](std::size_t k, DD sum) {
                      DD& gap = sums.gap[graph.contacts2[k]];
                      gap = difference(gap, sum);
                    })
                    .total;
  find_wraps(graph, sums);
  return sums;
}

}  // namespace lober::detail
