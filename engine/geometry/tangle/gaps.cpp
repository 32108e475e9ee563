#include "engine/geometry/tangle/gaps.hpp"

#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/index/sums_along.hpp"
#include "engine/geometry/smooth/smooth_gaps.hpp"

namespace lober::detail {

Buffer<DD> polygon_gaps_at(const IndexedCurve& u, const IndexedCurve& s, Point origin, const NodeGraph& graph,
                           std::span<const std::uint32_t> nodes) {
  const std::size_t count = nodes.size();
  Buffer<DD> along_u(count), along_s(count);
  if (count == 0) return along_u;
  // The same nodes in order along S.
  const Buffer<std::uint32_t>& along2 = graph.along2();
  Buffer<std::uint32_t> slots(graph.size()), order(count);
  constexpr std::uint32_t unwanted = 0xffffffff;
  std::fill(slots.begin(), slots.end(), unwanted);
  for (std::size_t k = 0; k < count; ++k) slots[nodes[k]] = static_cast<std::uint32_t>(k);
  std::size_t filled = 0;
  for (const std::uint32_t node : along2) {
    if (slots[node] != unwanted) order[filled++] = slots[node];
  }
  const auto contact = [&](std::size_t k) { return graph.contacts[graph.span(nodes[k]).first]; };
  parallel_if(
      u.segments() + s.segments() > 100'000,
      [&] {
        sum_along(
            u.tree(), origin, count,
            [&](std::size_t k) {
              return PrecisePosition{contact(k).segment1, contact(k).t1};
            },
            [&](std::size_t k, DD sum) { along_u[k] = sum; });
      },
      [&] {
        sum_along(
            s.tree(), origin, count,
            [&](std::size_t k) {
              return PrecisePosition{contact(order[k]).segment2, contact(order[k]).t2};
            },
            [&](std::size_t k, DD sum) { along_s[order[k]] = sum; });
      });
  for_each_block(count, std::size_t{1} << 14, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) along_u[k] -= along_s[k];
  });
  return along_u;
}

Buffer<DD> polygon_gaps_at(const TangleCurves& curves, const NodeGraph& graph, std::span<const std::uint32_t> nodes) {
  return polygon_gaps_at(curves.u(), curves.s(), curves.origin(), graph, nodes);
}

Buffer<DD> gaps_at(const TangleCurves& curves, const NodeGraph& graph, std::span<const std::uint32_t> nodes) {
  Buffer<DD> gaps = polygon_gaps_at(curves, graph, nodes);
  if (!curves.smooth || nodes.empty()) return gaps;
  const SmoothGaps smooth = curves.smooth_gaps_at(graph, nodes);
  for (std::size_t k = 0; k < nodes.size(); ++k) gaps[k] += smooth.at[k].twice;
  return gaps;
}

}  // namespace lober::detail
