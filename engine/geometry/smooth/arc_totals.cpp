#include "engine/geometry/smooth/arc_totals.hpp"
#include "engine/geometry/crossings/crossings_data.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <vector>

#include "engine/base/parallel/parallel.hpp"

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

// Classes of arcs of either curve: outside the other region, inside, and shared ones, by the directions of the curves
// when both run counter-clockwise; those of C2 count nowhere.
enum ArcClass : std::uint8_t { outside, inside, same, opposite, arc_classes };
using ClassSums = std::array<ChordArea, arc_classes>;

// A sum of areas and of their errors; areas as RunningSum.
struct AreaSum {
  double high = 0, low = 0, error = 0;
  void add(double term) {
    const DD sum = two_sum(high, term);
    high = sum.hi;
    low += sum.lo;
  }
  // Long runs in eight sums side by side.
  void add(const double* areas, const double* errors, std::size_t count) {
    constexpr std::size_t together = 8;
    std::size_t k = 0;
    if (count >= 8 * together) {
      std::array<double, together> highs{}, lows{}, all_errors{};
      for (; k + together <= count; k += together) {
        for (std::size_t j = 0; j < together; ++j) {
          const DD sum = two_sum(highs[j], areas[k + j]);
          highs[j] = sum.hi;
          lows[j] += sum.lo;
          all_errors[j] += errors[k + j];
        }
      }
      for (std::size_t j = 0; j < together; ++j) {
        add(highs[j]);
        low += lows[j];
        error += all_errors[j];
      }
    }
    for (; k < count; ++k) {
      add(areas[k]);
      error += errors[k];
    }
  }
  [[nodiscard]] ChordArea value() const { return {two_sum(high, low), error}; }
};

// Adds up a curve class by class. The contacts in order along it have segments, terms that they add before them, and
// classes of the arcs that follow. The segment of a contact belongs to the arc after it, and its term makes up for
// that. Returns the number of segments of positive length that stay straight.
template <typename SegmentOf, typename TermOf>
std::uint64_t add_by_class(CurveToAdd to_add, const SegmentOf& segment_of, const TermOf& term_of,
                           std::span<const std::uint8_t> class_after, ClassSums& sums) {
  constexpr std::size_t segments_a_block = 2048;
  const SmoothCurve& curve = to_add.curve;
  const std::size_t size = curve.segments(), count = class_after.size();
  std::vector<ClassSums> parts((size + segments_a_block - 1) / segments_a_block);
  std::vector<std::uint64_t> straight(parts.size());
  for_each_block(size, segments_a_block, [&](std::size_t begin, std::size_t end) {
    std::size_t next = 0;  // the first contact whose segment is not before the block
    for (std::size_t left = count; left > 0;) {
      const std::size_t half = left / 2;
      const bool before = segment_of(next + half) < begin;
      next += before ? half + 1 : 0;
      left = before ? left - half - 1 : half;
    }
    std::uint8_t now = outside;
    if (count > 0) now = class_after[next == 0 ? count - 1 : next - 1];
    std::array<AreaSum, arc_classes> of_block;
    SmoothCurve::Few few;
    for (std::size_t first = begin; first < end; first += SmoothCurve::Few::most) {
      const std::size_t last = std::min(first + SmoothCurve::Few::most, end);
      curve.fit(first, last, few);
      to_add.boxes.add(first, last, few.errors.data());
      straight[begin / segments_a_block] += few.straight;
      std::size_t from = first;
      for (; next < count; ++next) {
        const std::size_t segment = segment_of(next);
        if (segment >= last) break;
        const std::uint8_t then = class_after[next];
        if (then == now) continue;
        of_block[now].add(&few.areas[from - first], &few.errors[from - first], segment - from);
        from = segment;
        const double term = term_of(next);
        of_block[now].add(term);
        of_block[then].add(-term);
        now = then;
      }
      of_block[now].add(few.areas.data() + (from - first), few.errors.data() + (from - first), last - from);
    }
    for (std::size_t k = 0; k < arc_classes; ++k) parts[begin / segments_a_block][k] = of_block[k].value();
  });
  to_add.boxes.join();
  for (const ClassSums& part : parts) {
    for (std::size_t k = 0; k < arc_classes; ++k) sums[k] = sums[k] + part[k];
  }
  return std::accumulate(straight.begin(), straight.end(), std::uint64_t{0});
}

// A curve that meets no other.
ChordArea add_whole(CurveToAdd curve, std::uint64_t& straight) {
  ClassSums sums;
  const auto segment_of = [](std::size_t) { return std::size_t{0}; };
  const auto term_of = [](std::size_t) { return 0.0; };
  straight += add_by_class(curve, segment_of, term_of, {}, sums);
  return sums[outside];
}

// The class after each contact, in order along C1 and along C2.
struct ArcClasses {
  Buffer<std::uint8_t> after1, after2;

  explicit ArcClasses(const Crossings& nodes) : after1(0), after2(0) {
    const NodeGraph& graph = graph_of(nodes);
    const bool clockwise1 = nodes.clockwise1(), clockwise2 = nodes.clockwise2();
    const std::size_t contacts = graph.contacts.size();
    after1.resize(contacts);
    after2.resize(contacts);
    const auto class1 = [&](std::size_t node) {
      return static_cast<std::uint8_t>(forward1_left_of_2[graph.order[node]] != clockwise2);
    };
    const auto class2 = [&](std::size_t node) {
      return static_cast<std::uint8_t>(forward2_left_of_1[graph.order[node]] != clockwise1);
    };
    if (graph.spans.empty()) {
      for_each_block(contacts, contacts_a_task, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
          after1[k] = class1(k);
          after2[k] = class2(graph.contacts2[k]);
        }
      });
      return;
    }
    Buffer<std::uint32_t> rank_of_contact(contacts);
    for (std::size_t k = 0; k < contacts; ++k) rank_of_contact[graph.contacts2[k]] = static_cast<std::uint32_t>(k);
    std::fill(after1.begin(), after1.end(), arc_classes);
    std::fill(after2.begin(), after2.end(), arc_classes);
    for (std::uint32_t k = 0; k < graph.size(); ++k) {
      const NodeSpan span = graph.span(k);
      if (span.direction != 0) {
        after1[span.first] = (span.direction > 0) == (clockwise1 == clockwise2) ? same : opposite;
        after2[rank_of_contact[enters2(span)]] = same;
      }
      after1[span.last] = class1(k);
      after2[rank_of_contact[leaves2(span)]] = class2(k);
    }
    carry_on(after1);
    carry_on(after2);
  }

 private:
  static constexpr std::size_t contacts_a_task = 1 << 14;
  // Contacts within a shared arc do not change the class.
  static void carry_on(Buffer<std::uint8_t>& after) {
    const auto last = std::find_if(after.rbegin(), after.rend(), [](std::uint8_t k) { return k != arc_classes; });
    std::uint8_t now = *last;
    for (std::uint8_t& here : after) now = here = here == arc_classes ? now : here;
  }
};

}  // namespace

ChordArea operator+(const ChordArea& a, const ChordArea& b) {
  return {a.area + b.area, a.error + b.error};
}
ChordArea operator-(const ChordArea& a, const ChordArea& b) {
  return {a.area - b.area, a.error + b.error};
}

RegionChordAreas chord_areas_of_regions(const Crossings& nodes, const ArcEnds& ends, CurveToAdd c1, CurveToAdd c2) {
  const NodeGraph& graph = graph_of(nodes);
  const ArcClasses classes(nodes);
  ClassSums arcs1, arcs2;
  const auto segment1 = [&](std::size_t k) -> std::size_t { return graph.contacts[k].segment1; };
  const auto segment2 = [&](std::size_t k) -> std::size_t { return graph.contacts[graph.contacts2[k]].segment2; };
  const auto term1 = [&](std::size_t k) { return ends.on1[k]; };
  const auto term2 = [&](std::size_t k) { return ends.on2[graph.contacts2[k]]; };
  RegionChordAreas areas;
  areas.straight = add_by_class(c1, segment1, term1, classes.after1, arcs1);
  areas.straight += add_by_class(c2, segment2, term2, classes.after2, arcs2);
  for (ChordArea& sum : arcs1) sum = turned(sum, nodes.clockwise1());
  for (ChordArea& sum : arcs2) sum = turned(sum, nodes.clockwise2());
  const ChordArea uncertainty{{}, std::accumulate(ends.uncertainty.begin(), ends.uncertainty.end(), 0.0)};
  areas.c1 = arcs1[outside] + arcs1[inside] + arcs1[same] + arcs1[opposite];
  areas.c2 = arcs2[outside] + arcs2[inside] + arcs1[same] - arcs1[opposite];
  areas.only1 = arcs1[outside] - arcs2[inside] + arcs1[opposite] + uncertainty;
  areas.only2 = arcs2[outside] - arcs1[inside] - arcs1[opposite] + uncertainty;
  areas.both = arcs1[inside] + arcs2[inside] + arcs1[same] + uncertainty;
  areas.union_ = arcs1[outside] + arcs2[outside] + arcs1[same] + uncertainty;
  return areas;
}

RegionChordAreas chord_areas_apart(const Overlay& result, CurveToAdd curve1, CurveToAdd curve2) {
  RegionChordAreas areas;
  const ChordArea c1 = turned(add_whole(curve1, areas.straight), result.nodes.clockwise1());
  const ChordArea c2 = turned(add_whole(curve2, areas.straight), result.nodes.clockwise2());
  const auto with = [&](const ChordArea& second, const ChordArea& only1, const ChordArea& only2, const ChordArea& both,
                        const ChordArea& all) {
    return RegionChordAreas{c1, second, only1, only2, both, all, areas.straight};
  };
  if (result.nodes.same_curve()) return with(c1, {}, {}, c1, c1);
  if (result.areas.intersection == 0) return with(c2, c1, c2, {}, c1 + c2);
  if (result.areas.c1 >= result.areas.c2) return with(c2, c1 - c2, {}, c2, c1);
  return with(c2, {}, c2 - c1, c1, c2);
}

}  // namespace lober::detail
