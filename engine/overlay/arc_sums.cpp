#include "engine/overlay/arc_sums.hpp"

#include <algorithm>

#include "engine/parallel/parallel.hpp"
#include "kernels/shoelace.hpp"

namespace lober {
namespace {

// Leaves with contacts lie anywhere in memory; those of some contacts further on are asked for in time.
constexpr std::size_t ahead = 6;
void fetch(const Point* leaf) {
  constexpr std::size_t points_per_line = 64 / sizeof(Point);
  for (std::size_t k = 0; k < leaf_size; k += points_per_line) __builtin_prefetch(leaf + k);
}

// Running sums of one curve at each of its contacts. `contact(k)` gives (segment, parameter) of the k-th contact along
// the curve; take(k, sum) is called once for each, in parallel.
template <typename ContactAt, typename Take>
DD sum_at_contacts(const BoxTree& tree, Point origin, std::size_t count, const ContactAt& contact, const Take& take) {
  const Buffer<DD>& stretches = tree.stretch_sums();
  Buffer<DD> before(stretches.size());
  DD total;
  for (std::size_t k = 0; k < stretches.size(); ++k) {
    before[k] = total;
    total += stretches[k];
    total += shoelace(*tree.stretch_points(k), *tree.stretch_points(k + 1), origin);
  }
  if (count == 0) return total;

  // The first contact of a stretch, by bisection.
  const auto first_from = [&](std::size_t stretch) {
    std::size_t low = 0, high = count;
    while (low < high) {
      const std::size_t middle = low + (high - low) / 2;
      if (contact(middle).segment < stretch * leaf_size * leaf_size)
        low = middle + 1;
      else
        high = middle;
    }
    return low;
  };
  for_each_block(stretches.size(), 4, [&](std::size_t first_stretch, std::size_t last_stretch) {
    LeafPrefixes leaves, segments;
    std::size_t k = first_from(first_stretch);
    for (std::size_t stretch = first_stretch; stretch < last_stretch && k < count; ++stretch) {
      std::size_t segment = contact(k).segment;
      if (segment / leaf_size / leaf_size != stretch) continue;
      shoelace_prefixes(tree.stretch_points(stretch), origin, before[stretch], tree.leaf_sums() + stretch * leaf_size,
                        leaves);
      while (segment / leaf_size / leaf_size == stretch) {
        const std::size_t leaf = segment / leaf_size;
        if (k + ahead < count) fetch(tree.leaf_points(contact(k + ahead).segment / leaf_size));
        shoelace_prefixes(tree.leaf_points(leaf), origin, leaves.before(leaf % leaf_size), nullptr, segments);
        do {
          take(k, segments.at(segment % leaf_size, contact(k).t));
          if (++k == count) return;
          segment = contact(k).segment;
        } while (segment / leaf_size == leaf);
      }
    }
  });
  return total;
}

struct Place {
  std::uint32_t segment;
  DD t;
};

}  // namespace

void find_wraps(const NodeGraph& graph, ArcSums& sums) {
  const std::uint32_t nodes = graph.size();
  if (nodes == 0) return;
  if (graph.spans.empty()) {
    sums.wraps1 = sums.wraps2 = nodes - 1;
    return;
  }
  // A first vertex is passed where the next contact is not a later one.
  Buffer<std::uint32_t> place2(graph.contacts2.size());
  for (std::size_t k = 0; k < place2.size(); ++k) place2[graph.contacts2[k]] = static_cast<std::uint32_t>(k);
  const Buffer<std::uint32_t>& along2 = graph.along2();
  for (std::uint32_t k = 0; k < nodes; ++k) {
    const std::uint32_t next = k + 1 == nodes ? 0 : k + 1;
    const NodeSpan &here = graph.spans[k], &there = graph.spans[next];
    if (there.first <= here.last) sums.wraps1 = k;
    if (here.last < here.first) sums.wraps_inside = k;
    const NodeSpan &here2 = graph.spans[along2[k]], &there2 = graph.spans[along2[next]];
    const std::uint32_t leaves = here2.direction < 0 ? here2.first : here2.last;
    const std::uint32_t enters = there2.direction < 0 ? there2.last : there2.first;
    if (place2[enters] <= place2[leaves]) sums.wraps2 = k;
  }
}

ArcSums sum_arcs(const IndexedCurve& c1, const IndexedCurve& c2, const NodeGraph& graph) {
  const std::size_t count = graph.contacts.size();
  const Point origin = c1.view().points[0];
  ArcSums sums;
  sums.gap.resize(count);
  sums.total1 = sum_at_contacts(
      c1.tree(), origin, count,
      [&](std::size_t k) {
        return Place{graph.contacts[k].segment1, graph.contacts[k].t1};
      },
      [&](std::size_t k, DD sum) { sums.gap[k] = sum; });
  sums.total2 = sum_at_contacts(
      c2.tree(), origin, count,
      [&](std::size_t k) {
        const Contact& contact = graph.contacts[graph.contacts2[k]];
        return Place{contact.segment2, contact.t2};
      },
      [&](std::size_t k, DD sum) { sums.gap[graph.contacts2[k]] -= sum; });
  find_wraps(graph, sums);
  return sums;
}

}  // namespace lober
