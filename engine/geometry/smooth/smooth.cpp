#include "lober/overlay/smooth.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/crossings/crossings_data.hpp"
#include "engine/geometry/curve/scaled.hpp"
#include "engine/geometry/smooth/arc_totals.hpp"
#include "engine/geometry/smooth/chord_areas.hpp"
#include "engine/geometry/smooth/smooth_crossing.hpp"

namespace lober {
using namespace detail;
namespace {

constexpr std::size_t smooth_nodes_a_task = 256;

class Builder {
 public:
  // Areas of these curves times 2^exponent are those of the result.
  Builder(const Overlay& result, CurveView c1, CurveView c2, int exponent)
      : result_(result), graph_(graph_of(result.nodes)), c1_(c1), c2_(c2), exponent_(exponent) {}

  SmoothAreas build() {
    move_crossings();
    restore_order();
    ArcEnds ends = sum_at_contacts();
    SmoothAreas smooth;
    smooth.fallback_segments = fallback_segments_;
    smooth.fallback_crossings = fallback_crossings_;
    const RegionChordAreas chord_areas = graph_.size() > 0 ? chord_areas_of_regions(result_.nodes, ends)
                                                           : chord_areas_apart(result_, ends.total1, ends.total2);
    add(&Areas::c1, chord_areas.c1, smooth);
    add(&Areas::c2, chord_areas.c2, smooth);
    add(&Areas::c1_minus_c2, chord_areas.only1, smooth);
    add(&Areas::c2_minus_c1, chord_areas.only2, smooth);
    add(&Areas::intersection, chord_areas.both, smooth);
    add(&Areas::union_, chord_areas.union_, smooth);
    add(&Areas::symmetric_difference, chord_areas.only1 + chord_areas.only2, smooth);
    return smooth;
  }

 private:
  [[nodiscard]] bool is_crossing(std::uint32_t node) const {
    return graph_.span(node).direction == 0 && graph_.order[node] < first_touch;
  }
  void move_crossings() {
    moved_.resize(graph_.size());
    straight_.resize(graph_.contacts.size());
    ends_.resize(graph_.contacts.size());
    for_each_block(graph_.size(), smooth_nodes_a_task, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        const auto node = static_cast<std::uint32_t>(k);
        const NodeSpan span = graph_.span(node);
        for (const std::uint32_t contact : {span.first, span.last}) {
          SmoothContact smooth(c1_, c2_, graph_.contacts[contact]);
          straight_[contact] = smooth.straight();
          if (is_crossing(node) && !straight_[contact]) {
            moved_[k] = smooth.move_to_crossing(graph_.order[node] == rightward_to_left);
          }
          ends_[contact] = smooth.ends();
          if (span.first == span.last) break;
        }
      }
    });
  }

  // Crossings that would overtake one another stay where they were. That may put them in the way of others, so look
  // again, a few times.
  void restore_order() {
    const std::uint32_t count = graph_.size();
    const Buffer<std::uint32_t>& along2 = graph_.along2();
    bool changed = count > 1;
    for (int round = 0; changed && round < 8; ++round) {
      changed = false;
      for (std::uint32_t k = 0; k < count; ++k) {
        const std::uint32_t next = k + 1 == count ? 0 : k + 1;
        const NodeSpan here = graph_.span(k), there = graph_.span(next);
        if (overtakes<&SmoothCrossing::position1>(k, here.last, next, there.first)) changed |= put_back(k, next);
        const std::uint32_t from = along2[k], to = along2[next];
        const std::uint32_t leaves = leaves2(graph_.span(from)), enters = enters2(graph_.span(to));
        if (overtakes<&SmoothCrossing::position2>(from, leaves, to, enters)) changed |= put_back(from, to);
      }
    }
  }
  // Whether a node and the one that follows it along a curve have changed their order. Their contacts say whether the
  // first vertex lies between them.
  template <SmoothPosition SmoothCrossing::*on>
  [[nodiscard]] bool overtakes(std::uint32_t node, std::uint32_t contact, std::uint32_t next,
                               std::uint32_t next_contact) const {
    constexpr bool first = on == &SmoothCrossing::position1;
    const auto position = [](const SmoothPosition& at) { return static_cast<double>(at.segment) + at.u; };
    const auto before = [&](std::uint32_t k) {
      const Contact at = graph_.contacts[k];
      return position(first ? SmoothPosition{at.segment1, at.t1.hi} : SmoothPosition{at.segment2, at.t2.hi});
    };
    const double turn =
        before(next_contact) < before(contact) ? static_cast<double>((first ? c1_ : c2_).segments()) : 0;
    const double from = moved_[node] ? position((*moved_[node]).*on) : before(contact);
    const double to = moved_[next] ? position((*moved_[next]).*on) : before(next_contact);
    return from > to + turn;
  }
  bool put_back(std::uint32_t node, std::uint32_t other) {
    const bool any = moved_[node].has_value() || moved_[other].has_value();
    for (const std::uint32_t k : {node, other}) {
      if (!moved_[k]) continue;
      moved_[k].reset();
      const std::uint32_t contact = graph_.span(k).first;
      ends_[contact] = SmoothContact(c1_, c2_, graph_.contacts[contact]).ends();
    }
    return any;
  }

  ArcEnds sum_at_contacts() {
    const std::size_t count = graph_.contacts.size();
    std::vector<std::uint32_t> segments1(count), segments2(count);
    for (std::size_t k = 0; k < count; ++k) {
      segments1[k] = graph_.contacts[k].segment1;
      segments2[k] = graph_.contacts[graph_.contacts2[k]].segment2;
    }
    const ChordAreaTable sums1(c1_), sums2(c2_);
    fallback_segments_ = sums1.fallbacks() + sums2.fallbacks();
    ArcEnds ends{sums1.before(c1_, segments1), Buffer<ChordArea>(count), sums1.total(), sums2.total(), 0};
    const Buffer<ChordArea> before2 = sums2.before(c2_, segments2);
    for (std::size_t k = 0; k < count; ++k) ends.on2[graph_.contacts2[k]] = before2[k];

    for (std::uint32_t k = 0; k < graph_.size(); ++k) {
      const NodeSpan span = graph_.span(k);
      double uncertainty = 0;
      for (const std::uint32_t contact : {span.first, span.last}) {
        if (straight_[contact] == 0) {
          ends.on1[contact].area += DD{ends_[contact].on1, 0};
          ends.on2[contact].area += DD{ends_[contact].on2, 0};
        }
        uncertainty += ends_[contact].uncertainty;
        if (span.first == span.last) break;
      }
      ends.uncertainty += uncertainty;
      fallback_crossings_ += is_crossing(k) && straight_[span.first] == 0 && !moved_[k];
    }
    return ends;
  }

  // An area that comes out negative is one that smooth curves do not enclose.
  void add(double Areas::*member, const ChordArea& chord_area, SmoothAreas& smooth) const {
    const auto half = [&](double twice) { return scaled_area(twice, exponent_ - 1); };
    const double area = result_.areas.*member + half(chord_area.area.hi + chord_area.area.lo);
    smooth.areas.*member = std::max(area, 0.0);
    smooth.error.*member = result_.rounding.*member + half(chord_area.error) + std::max(-area, 0.0) +
                           (chord_area.area.hi == 0 ? 0 : std::fabs(area) * 0x1p-53);
  }

  const Overlay& result_;
  const NodeGraph& graph_;
  SmoothCurve c1_, c2_;
  int exponent_;
  std::vector<std::optional<SmoothCrossing>> moved_;  // by node
  std::vector<char> straight_;                        // by contact
  Buffer<EndOfArcs> ends_;                            // by contact
  std::uint64_t fallback_segments_ = 0, fallback_crossings_ = 0;
};

}  // namespace

SmoothAreas smooth_areas(const Overlay& result) {
  const CurveView &c1 = result.nodes.curve1(), &c2 = result.nodes.curve2();
  const int exponent = scaling_exponent(union_of(box_of(c1.points), box_of(c2.points)));
  if (exponent == 0) return Builder(result, c1, c2, 0).build();
  const std::vector<Point> first = scaled(c1, exponent), second = scaled(c2, exponent);
  return Builder(result, CurveView{first}, CurveView{second}, -2 * exponent).build();
}

}  // namespace lober
