#include "engine/geometry/smooth/smooth_gaps.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/smooth/chord_areas.hpp"
#include "engine/geometry/smooth/smooth_crossing.hpp"

namespace lober::detail {
namespace {

constexpr std::size_t gaps_a_task = 256;

class GapFinder {
 public:
  GapFinder(const SmoothCurve& c1, const SmoothCurve& c2, const NodeGraph& graph, std::span<const std::uint32_t> nodes)
      : c1_(c1), c2_(c2), graph_(graph), nodes_(nodes), found_(nodes.size()) {}

  SmoothGaps find(const ChordAreaTable& table1, const ChordAreaTable& table2) {
    for_each_block(nodes_.size(), gaps_a_task, [&](std::size_t begin, std::size_t end) {
      Buffer<PolygonContact> polygons;
      polygons.reserve(end - begin);
      for (std::size_t k = begin; k < end; ++k) {
        const bool crosses = graph_.span(nodes_[k]).direction == 0;
        const auto sense = crosses ? sense_of(graph_.order[nodes_[k]]) : PolygonContact::Sense::stays;
        polygons.push_back(polygon_contact(contact(k), sense));
      }
      move_contacts(c1_, c2_, polygons, true, std::span(found_).subspan(begin, end - begin));
    });
    // In order along C2.
    std::vector<std::uint32_t> order(nodes_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t x, std::uint32_t y) { return graph_.rank2[nodes_[x]] < graph_.rank2[nodes_[y]]; });
    restore_order(order);

    SmoothGaps gaps;
    gaps.at.resize(nodes_.size());
    std::vector<std::uint32_t> segments1(nodes_.size()), segments2(nodes_.size());
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      segments1[k] = contact(k).segment1;
      segments2[k] = contact(order[k]).segment2;
    }
    const Buffer<ChordArea> before1 = table1.before(c1_, segments1), before2 = table2.before(c2_, segments2);
    gaps.fallback_segments = table1.fallbacks() + table2.fallbacks();
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      gaps.at[k].twice += before1[k].area;
      gaps.at[k].error1 = before1[k].error;
      gaps.at[order[k]].twice -= before2[k].area;
      gaps.at[order[k]].error2 = before2[k].error;
    }
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      SmoothGap& gap = gaps.at[k];
      const EndOfArcs& end = found_[k].ends;
      gap.twice += two_diff(end.on1, end.on2);
      gap.uncertainty = end.uncertainty;
      gap.moved = found_[k].moved;
      gap.position1 = position(k, true);
      gap.position2 = position(k, false);
      gap.at = gap.moved ? point_at(found_[k].on1) : contact_point(contact(k), c1_.view(), c2_.view());
      gaps.fallback_crossings += !gap.moved;
    }
    return gaps;
  }

 private:
  [[nodiscard]] Contact contact(std::size_t k) const { return graph_.contacts[graph_.span(nodes_[k]).first]; }
  [[nodiscard]] Point point_at(const SmoothPosition& at) const {
    const Point from = c1_.vertex(at.segment), offset = c1_.segment(at.segment).at(at.u);
    return {from.x + offset.x, from.y + offset.y};
  }
  [[nodiscard]] double position(std::size_t k, bool on_first) const {
    const SmoothPosition& at = on_first ? found_[k].on1 : found_[k].on2;
    return static_cast<double>(at.segment) + at.u;
  }

  // Crossings that would overtake one another stay where they were, which may put them in the way of others.
  void restore_order(const std::vector<std::uint32_t>& order) {
    bool changed = true;
    const auto keep_apart = [&](std::size_t k, std::size_t next, bool on_first) {
      if (position(k, on_first) <= position(next, on_first)) return;
      for (const std::size_t node : {k, next}) {
        if (!found_[node].moved) continue;
        changed = true;
        const PolygonContact polygons = polygon_contact(contact(node), PolygonContact::Sense::stays);
        move_contacts(c1_, c2_, {&polygons, 1}, true, {&found_[node], 1});
      }
    };
    while (changed) {
      changed = false;
      for (std::size_t k = 0; k + 1 < order.size(); ++k) {
        keep_apart(k, k + 1, true);
        keep_apart(order[k], order[k + 1], false);
      }
    }
  }

  SmoothCurve c1_, c2_;
  const NodeGraph& graph_;
  std::span<const std::uint32_t> nodes_;
  std::vector<SmoothContact> found_;
};

}  // namespace

SmoothGaps smooth_gaps(const SmoothCurve& c1, const SmoothCurve& c2, const ChordAreaTable& sums1,
                       const ChordAreaTable& sums2, const NodeGraph& graph, std::span<const std::uint32_t> nodes) {
  return GapFinder(c1, c2, graph, nodes).find(sums1, sums2);
}

}  // namespace lober::detail
