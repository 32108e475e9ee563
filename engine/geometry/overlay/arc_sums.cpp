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

// Sums of a short curve are about its own first vertex, so that they can be kept for all curves that it meets.
bool is_short(const IndexedCurve& curve) {
  return curve.segments() <= KeptSums::max_segments;
}

// sum_along about the first vertex of a short curve.
template <typename PositionAt, typename Take>
DD sum_along_short(const BoxTree& tree, std::size_t count, const PositionAt& position, const Take& take) {
  const KeptSums* const kept = tree.kept_sums();
  if (kept == nullptr) return sum_along(tree, tree.leaf_begin(0), count, position, take).total;
  for (std::size_t k = 0; k < count; ++k) {
    const PrecisePosition at = position(k);
    take(k, kept->up_to(at.segment, at.t));
  }
  return kept->total();
}

// The gain of the sum along a curve from v when its origin o = v is exchanged for another, o': all terms
// cross(o - o', v_{i+1} - v_i) add up to cross(v - o', p - v) at a point p.
class Origins {
 public:
  Origins(Point from, Point to) : from_(from), x_(two_diff(from.x, to.x)), y_(two_diff(from.y, to.y)) {}

  [[nodiscard]] DD difference_at(const CurveView& curve, const PrecisePosition& at) const {
    const auto [a, b] = curve.segment(at.segment);
    const DD x = two_diff(a.x, from_.x) + at.t * two_diff(b.x, a.x),
             y = two_diff(a.y, from_.y) + at.t * two_diff(b.y, a.y);
    return cross(x_, y_, x, y);
  }

 private:
  Point from_;
  DD x_, y_;
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
  const bool short_curves = is_short(c1) && is_short(c2);
  const Point origin = c1.view().points[0], origin2 = short_curves ? c2.view().points[0] : origin;
  ArcSums sums;
  sums.gap.resize(count);
  const auto take1 = [&](std::size_t k, DD sum) { sums.gap[k] = sum; };
  const auto take2 = [&](std::size_t k, DD sum) {
    DD& gap = sums.gap[graph.contacts2[k]];
    gap = difference(gap, sum);
  };
  const auto position1 = [&](std::size_t k) {
    return PrecisePosition{graph.contacts[k].segment1, graph.contacts[k].t1};
  };
  const auto position2 = [&](std::size_t k) {
    const Contact contact = graph.contacts[graph.contacts2[k]];
    return PrecisePosition{contact.segment2, contact.t2};
  };
  if (short_curves) {
    const Origins origins(origin2, origin);
    sums.total1 = sum_along_short(c1.tree(), count, position1, take1);
    sums.total2 = sum_along_short(c2.tree(), count, position2, [&](std::size_t k, DD sum) {
      take2(k, sum + origins.difference_at(c2.view(), position2(k)));
    });
  } else {
    sums.total1 = sum_along(c1.tree(), origin, count, position1, take1).total;
    sums.total2 = sum_along(c2.tree(), origin, count, position2, take2).total;
  }
  find_wraps(graph, sums);
  return sums;
}

}  // namespace lober::detail
