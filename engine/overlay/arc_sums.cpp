#include "engine/overlay/arc_sums.hpp"

#include <algorithm>

#include "engine/parallel/parallel.hpp"
#include "kernels/shoelace.hpp"

namespace lober {
namespace {

constexpr std::size_t node_grain = std::size_t{1} << 13;

// Running sums of one curve at each of its contacts. `contact(k)` gives (segment, parameter) of the k-th contact along
// the curve.
template <typename ContactAt>
Buffer<DD> sums_at_contacts(const BoxTree& tree, Point origin, std::size_t count, const ContactAt& contact, DD& total) {
  const Buffer<DD>& stretches = tree.stretch_sums();
  const std::size_t leaves = tree.leaves();
  Buffer<DD> before(stretches.size());
  DD sum;
  for (std::size_t k = 0; k < stretches.size(); ++k) {
    before[k] = sum;
    sum += stretches[k];
    sum += shoelace(tree.leaf_begin(k * leaf_size), tree.leaf_begin(std::min((k + 1) * leaf_size, leaves)), origin);
  }
  total = sum;

  Buffer<DD> sums(count);
  if (count == 0) return sums;
  for_each_block(stretches.size(), 4, [&](std::size_t first_stretch, std::size_t last_stretch) {
    std::array<DD, leaf_size> terms;
    // The first contact of the stretch, by bisection.
    const auto first_at = [&](std::size_t begin_segment) {
      std::size_t low = 0, high = count;
      while (low < high) {
        const std::size_t middle = low + (high - low) / 2;
        if (contact(middle).segment < begin_segment)
          low = middle + 1;
        else
          high = middle;
      }
      return low;
    };
    std::size_t k = first_at(first_stretch * leaf_size * leaf_size);
    for (std::size_t stretch = first_stretch; stretch < last_stretch; ++stretch) {
      RunningSum running;
      running.add(before[stretch]);
      const std::size_t leaf_end = std::min((stretch + 1) * leaf_size, leaves);
      for (std::size_t leaf = stretch * leaf_size; leaf < leaf_end; ++leaf) {
        if (k == count) return;
        if (contact(k).segment >= leaf_end * leaf_size) break;  // nothing more in this stretch
        if (contact(k).segment >= (leaf + 1) * leaf_size) {
          running.add(tree.leaf_sums()[leaf]);
          running.add(shoelace(tree.leaf_begin(leaf), tree.leaf_begin(leaf + 1), origin));
          continue;
        }
        shoelace_terms(tree.leaf_points(leaf), origin, terms.data());
        for (std::size_t i = 0; i < leaf_size; ++i) {
          for (; k < count && contact(k).segment == leaf * leaf_size + i; ++k) {
            sums[k] = running.value() + contact(k).t * terms[i];
          }
          running.add(terms[i]);
        }
      }
    }
  });
  return sums;
}

struct Place {
  std::uint32_t segment;
  DD t;
};

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
  Buffer<DD> sums1, sums2;
  DD total1, total2;
  run_together(
      count > node_grain,
      [&] {
        sums1 = sums_at_contacts(
            c1.tree(), origin, count,
            [&](std::size_t k) {
              return Place{graph.contacts[k].segment1, graph.contacts[k].t1};
            },
            total1);
      },
      [&] {
        sums2 = sums_at_contacts(
            c2.tree(), origin, count,
            [&](std::size_t k) {
              const Contact& contact = graph.contacts[graph.contacts2[k]];
              return Place{contact.segment2, contact.t2};
            },
            total2);
      });
  return sums_between_nodes(graph, std::move(sums1), total1, std::move(sums2), total2);
}

}  // namespace lober
