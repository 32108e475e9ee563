#include "lober/overlay/smooth.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/crossings/crossings_data.hpp"
#include "engine/geometry/curve/scaled.hpp"
#include "engine/geometry/smooth/arc_totals.hpp"
#include "engine/geometry/smooth/chord_areas.hpp"
#include "engine/geometry/smooth/near_misses.hpp"
#include "engine/geometry/smooth/smooth_crossing.hpp"

namespace lober {
using namespace detail;
namespace {

constexpr std::size_t smooth_nodes_a_task = 1024;

class Builder {
 public:
  // Areas of these curves times 2^exponent are those of the result.
  Builder(const Overlay& result, CurveView c1, CurveView c2, int exponent)
      : result_(result),
        graph_(graph_of(result.nodes)),
        c1_(c1),
        c2_(c2),
        boxes1_(c1_),
        boxes2_(c2_),
        exponent_(exponent) {}

  SmoothAreas build() {
    move_crossings();
    restore_order();
    end_arcs_put_back();
    const CurveToAdd first{c1_, boxes1_}, second{c2_, boxes2_};
    RegionChordAreas chord_areas = graph_.size() > 0 ? chord_areas_of_regions(result_.nodes, ends_, first, second)
                                                     : chord_areas_apart(result_, first, second);
    const double hidden = hidden_where_polygons_miss();
    for (ChordArea* const area : {&chord_areas.only1, &chord_areas.only2, &chord_areas.both, &chord_areas.union_})
      area->error += hidden;
    SmoothAreas smooth;
    smooth.fallback_segments = chord_areas.straight;
    smooth.fallback_crossings = unmoved_.size() + put_back_.size();
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
    const std::size_t contacts = graph_.contacts.size();
    for (Buffer<double>* terms : {&ends_.on1, &ends_.on2, &ends_.uncertainty}) {
      if (graph_.spans.empty())
        terms->resize(contacts);
      else
        terms->assign(contacts, 0);
    }
    at1_.resize(contacts);
    at2_.resize(contacts);
    std::vector<std::vector<std::uint32_t>> unmoved(graph_.size() / smooth_nodes_a_task + 1);
    for_each_block(graph_.size(), smooth_nodes_a_task, [&](std::size_t begin, std::size_t end) {
      Buffer<PolygonContact> polygons;
      polygons.reserve(end - begin);
      Buffer<std::uint32_t> numbers;
      numbers.reserve(end - begin);
      for (std::size_t k = begin; k < end; ++k) {
        const auto node = static_cast<std::uint32_t>(k);
        const NodeSpan span = graph_.span(node);
        moved_[k] = 0;
        const auto sense = is_crossing(node) ? sense_of(graph_.order[node]) : PolygonContact::Sense::stays;
        for (const std::uint32_t contact : {span.first, span.last}) {
          polygons.push_back(polygon_contact(graph_.contacts[contact], sense));
          numbers.push_back(contact);
          if (span.first == span.last) break;
        }
      }
      Buffer<SmoothContact> found(polygons.size());
      move_contacts(c1_, c2_, polygons, false, found);
      std::size_t next = 0;
      for (std::size_t k = begin; k < end; ++k) {
        const NodeSpan span = graph_.span(static_cast<std::uint32_t>(k));
        for (const std::uint32_t contact : {span.first, span.last}) {
          keep(contact, found[next]);
          moved_[k] |= static_cast<char>(found[next].moved);
          if (polygons[next].sense != PolygonContact::Sense::stays && !found[next].straight && !found[next].moved)
            unmoved[begin / smooth_nodes_a_task].push_back(contact);
          ++next;
          if (span.first == span.last) break;
        }
      }
    });
    for (const std::vector<std::uint32_t>& some : unmoved) unmoved_.insert(unmoved_.end(), some.begin(), some.end());
  }
  void keep(std::uint32_t contact, const SmoothContact& found) {
    const auto position = [](const SmoothPosition& at) { return static_cast<double>(at.segment) + at.u; };
    ends_.on1[contact] = found.straight ? 0 : found.ends.on1;
    ends_.on2[contact] = found.straight ? 0 : found.ends.on2;
    ends_.uncertainty[contact] = found.ends.uncertainty;
    at1_[contact] = position(found.on1);
    at2_[contact] = position(found.on2);
  }

  // Crossings that would overtake one another stay where they were. That may put them in the way of others, so look
  // again, a few times, where something has changed.
  void restore_order() {
    const std::uint32_t count = graph_.size();
    if (count < 2) return;
    std::vector<std::uint64_t> suspects((count + 63) / 64);  // bits of ranks: see overtakes_along
    for_each_block(suspects.size(), smooth_nodes_a_task / 64, [&](std::size_t begin, std::size_t end) {
      for (auto k = static_cast<std::uint32_t>(begin * 64); k < std::min<std::size_t>(count, end * 64); ++k) {
        const bool either = overtakes_along<1>(k) || overtakes_along<2>(k);
        suspects[k / 64] |= static_cast<std::uint64_t>(either) << k % 64;
      }
    });
    bool changed = true;
    for (int round = 0; changed && round < 8; ++round) {
      changed = false;
      for (std::size_t word = 0; word < suspects.size(); ++word) {
        for (std::uint64_t left = suspects[word]; left != 0;) {
          const auto bit = static_cast<std::uint32_t>(std::countr_zero(left));
          suspects[word] &= ~(1ULL << bit);
          const std::uint32_t rank = static_cast<std::uint32_t>(word * 64) + bit;
          if (overtakes_along<1>(rank)) changed |= put_back(rank, after(rank), suspects);
          const Buffer<std::uint32_t>& along2 = graph_.along2();
          if (overtakes_along<2>(rank)) changed |= put_back(along2[rank], along2[after(rank)], suspects);
          left = suspects[word] & (~1ULL << bit);
        }
      }
    }
  }
  [[nodiscard]] std::uint32_t after(std::uint32_t rank) const { return rank + 1 == graph_.size() ? 0 : rank + 1; }
  // Whether the node of that rank along a curve and the one that follows it have changed their order.
  template <int curve>
  [[nodiscard]] bool overtakes_along(std::uint32_t rank) const {
    if constexpr (curve == 1) {
      return overtakes(at1_, graph_.span(rank).last, graph_.span(after(rank)).first, true);
    } else {
      const NodeSpan here = graph_.span(graph_.along2()[rank]), there = graph_.span(graph_.along2()[after(rank)]);
      return overtakes(at2_, leaves2(here), enters2(there), false);
    }
  }
  // The contacts of the polygons say whether the first vertex lies between two.
  [[nodiscard]] bool overtakes(const Buffer<double>& at, std::uint32_t contact, std::uint32_t next,
                               bool on_first) const {
    if (at[contact] <= at[next]) return false;
    const bool first_vertex = polygon_position(next, on_first) < polygon_position(contact, on_first);
    return at[contact] > at[next] + (first_vertex ? static_cast<double>((on_first ? c1_ : c2_).segments()) : 0);
  }
  // Where a contact of the polygons is along one of them.
  [[nodiscard]] double polygon_position(std::uint32_t contact, bool on_first) const {
    const Contact here = graph_.contacts[contact];
    return on_first ? here.segment1 + here.t1.hi : here.segment2 + here.t2.hi;
  }
  // Ranks beside those that are put back become suspects. Whether any had been moved.
  bool put_back(std::uint32_t node, std::uint32_t other, std::vector<std::uint64_t>& suspects) {
    bool any = false;
    const std::uint32_t count = graph_.size();
    for (const std::uint32_t k : {node, other}) {
      if (moved_[k] == 0) continue;
      any = true;
      moved_[k] = 0;
      const std::uint32_t contact = graph_.span(k).first;
      const Contact here = graph_.contacts[contact];
      at1_[contact] = here.segment1 + here.t1.hi;
      at2_[contact] = here.segment2 + here.t2.hi;
      put_back_.push_back(contact);
      for (const std::uint32_t rank : {k, graph_.rank2[k]}) {
        for (const std::uint32_t first : {rank, rank == 0 ? count - 1 : rank - 1}) {
          suspects[first / 64] |= 1ULL << first % 64;
        }
      }
    }
    return any;
  }
  void end_arcs_put_back() {
    std::sort(put_back_.begin(), put_back_.end());
    for_each_block(put_back_.size(), smooth_nodes_a_task, [&](std::size_t begin, std::size_t end) {
      Buffer<PolygonContact> polygons;
      polygons.reserve(end - begin);
      for (std::size_t k = begin; k < end; ++k) {
        polygons.push_back(polygon_contact(graph_.contacts[put_back_[k]], PolygonContact::Sense::stays));
      }
      Buffer<SmoothContact> found(end - begin);
      move_contacts(c1_, c2_, polygons, false, found);
      for (std::size_t k = begin; k < end; ++k) keep(put_back_[k], found[k - begin]);
    });
  }

  // Twice the area of lobes that smooth curves make where their polygons pass by each other.
  [[nodiscard]] double hidden_where_polygons_miss() const {
    if (result_.nodes.same_curve()) return 0;
    NodeSegments about1(c1_.segments()), about2(c2_.segments());
    for_each_block(graph_.size(), smooth_nodes_a_task, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        const NodeSpan span = graph_.span(static_cast<std::uint32_t>(k));
        add(about1, at1_, span.first, span.last, true);
        add(about2, at2_, enters2(span), leaves2(span), false);
      }
    });
    for (const auto& contacts : {std::span<const std::uint32_t>(unmoved_), std::span<const std::uint32_t>(put_back_)}) {
      for (const std::uint32_t contact : contacts) {
        const double on1 = polygon_position(contact, true), on2 = polygon_position(contact, false);
        about1.remove(on1, on1);
        about2.remove(on2, on2);
      }
    }
    about1.join();
    about2.join();
    return hidden_area({c1_, boxes1_, about1}, {c2_, boxes2_, about2});
  }
  // The segments of one curve about a node, which begins and ends at these contacts along it.
  void add(NodeSegments& about, const Buffer<double>& at, std::uint32_t first, std::uint32_t last,
           bool on_first) const {
    const double begin = polygon_position(first, on_first), end = polygon_position(last, on_first);
    const double turn = end < begin ? static_cast<double>((on_first ? c1_ : c2_).segments()) : 0;
    about.add(begin, at[first]);
    if (first == last) return;
    about.add(begin, end + turn);
    about.add(end, at[last]);
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
  ArcBoxes boxes1_, boxes2_;
  int exponent_;
  Buffer<char> moved_;                  // by node
  std::vector<std::uint32_t> unmoved_;  // contacts of crossings that should have been moved
  Buffer<std::uint32_t> put_back_;      // contacts that have moved, and were put back
  ArcEnds ends_;                        // by contact
  Buffer<double> at1_, at2_;            // by contact: numbers of segments and parameters, where it has been moved to
};

}  // namespace

SmoothAreas smooth_areas(const Overlay& result) {
  const CurveView &c1 = result.nodes.curve1(), &c2 = result.nodes.curve2();
  const int exponent = result.nodes.data().exponent;
  if (exponent == 0) return Builder(result, c1, c2, 0).build();
  const std::vector<Point> first = scaled(c1, exponent), second = scaled(c2, exponent);
  return Builder(result, CurveView{first}, CurveView{second}, -2 * exponent).build();
}

}  // namespace lober
