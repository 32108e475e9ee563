#include "engine/geometry/smooth/arc_totals.hpp"
#include "engine/geometry/crossings/crossings_data.hpp"

#include <array>
#include <cmath>

namespace lober::detail {
namespace {

using enum HalfEdge;

// For each rotation whether the arc that leaves along `half_edge` is on the left of the other curve, as the input runs.
constexpr std::array<bool, 6> on_left(HalfEdge half_edge, HalfEdge other_out, HalfEdge other_in) {
  std::array<bool, 6> left{};
  for (std::size_t order = 0; order < 6; ++order) {
    std::array<unsigned, 4> rank{};
    for (unsigned k = 0; k < 4; ++k) rank[index_of(rotations[order][k])] = k;
    const unsigned out = rank[index_of(other_out)];
    left[order] = (rank[index_of(half_edge)] + 4 - out) % 4 < (rank[index_of(other_in)] + 4 - out) % 4;
  }
  return left;
}
constexpr std::array<bool, 6> forward1_left_of_2 = on_left(forward1, forward2, backward2),
                              forward2_left_of_1 = on_left(forward2, forward1, backward1);

ChordArea turned(const ChordArea& chord_area, bool clockwise) {
  return {clockwise ? -chord_area.area : chord_area.area, chord_area.error};
}

// The arc from one running sum to another. Errors are running sums too, so theirs is a difference.
ChordArea between(const ChordArea& from, const ChordArea& to) {
  return {to.area - from.area, std::fabs(to.error - from.error)};
}
ChordArea between(const ChordArea& from, const ChordArea& to, const ChordArea& turn) {
  return {to.area - from.area + turn.area, std::fabs(to.error - from.error + turn.error)};
}

}  // namespace

ChordArea operator+(const ChordArea& a, const ChordArea& b) {
  return {a.area + b.area, a.error + b.error};
}
ChordArea operator-(const ChordArea& a, const ChordArea& b) {
  return {a.area - b.area, a.error + b.error};
}

RegionChordAreas chord_areas_of_regions(const Crossings& nodes, const ArcEnds& ends) {
  const NodeGraph& graph = graph_of(nodes);
  const bool clockwise1 = nodes.clockwise1(), clockwise2 = nodes.clockwise2();
  const std::uint32_t count = graph.size();
  const Buffer<std::uint32_t>& along2 = graph.along2();
  Buffer<std::uint32_t> rank_of_contact(graph.contacts2.size());
  for (std::size_t k = 0; k < rank_of_contact.size(); ++k) {
    rank_of_contact[graph.contacts2[k]] = static_cast<std::uint32_t>(k);
  }
  std::array<ChordArea, 2> arcs1, arcs2;  // outside the other region, inside
  ChordArea same, opposite;  // shared arcs, by the directions of the curves when both run counter-clockwise
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::uint32_t next = k + 1 == count ? 0 : k + 1;
    const NodeSpan here = graph.span(k), there = graph.span(next);
    const auto arc = [](const Buffer<ChordArea>& sums, std::uint32_t from, std::uint32_t to, bool past_start,
                        const ChordArea& total) {
      return past_start ? between(sums[from], sums[to], total) : between(sums[from], sums[to]);
    };
    ChordArea& sum1 = arcs1[forward1_left_of_2[graph.order[k]] != clockwise2];
    sum1 = sum1 + turned(arc(ends.on1, here.last, there.first, there.first <= here.last, ends.total1), clockwise1);
    if (here.direction != 0) {
      ChordArea& sum = (here.direction > 0) == (clockwise1 == clockwise2) ? same : opposite;
      sum = sum + turned(arc(ends.on1, here.first, here.last, here.last < here.first, ends.total1), clockwise1);
    }
    const std::uint32_t node2 = along2[k];
    const std::uint32_t from = leaves2(graph.span(node2)), to = enters2(graph.span(along2[next]));
    ChordArea& sum2 = arcs2[forward2_left_of_1[graph.order[node2]] != clockwise1];
    sum2 =
        sum2 + turned(arc(ends.on2, from, to, rank_of_contact[to] <= rank_of_contact[from], ends.total2), clockwise2);
  }
  const ChordArea uncertainty{{}, ends.uncertainty};
  return {arcs1[0] + arcs1[1] + same + opposite,        arcs2[0] + arcs2[1] + same - opposite,
          arcs1[0] - arcs2[1] + opposite + uncertainty, arcs2[0] - arcs1[1] - opposite + uncertainty,
          arcs1[1] + arcs2[1] + same + uncertainty,     arcs1[0] + arcs2[0] + same + uncertainty};
}

RegionChordAreas chord_areas_apart(const Overlay& result, const ChordArea& total1, const ChordArea& total2) {
  const ChordArea c1 = turned(total1, result.nodes.clockwise1()), c2 = turned(total2, result.nodes.clockwise2());
  if (result.nodes.same_curve()) return {c1, c1, {}, {}, c1, c1};
  if (result.areas.intersection == 0) return {c1, c2, c1, c2, {}, c1 + c2};
  if (result.areas.c1 >= result.areas.c2) return {c1, c2, c1 - c2, {}, c2, c1};
  return {c1, c2, {}, c2 - c1, c1, c2};
}

}  // namespace lober::detail
