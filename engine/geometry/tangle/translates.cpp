// The common areas of lobes with those of a moved copy of the tangle: overlaps.cpp for two tangles that are
// the same but for a translation.
//
// Let lobe j' be lobe j, moved. U and U' do not meet, nor do S and S', so that the boundary of what i and j' have in
// common ends at crossings of U_i with S'_j and of U'_j with S_i. Both contribute o_i o_j rho D, as in one tangle, and
// D may be taken about any point, because the rho of each pair of arcs add up to zero.

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "engine/geometry/crossings/crossings_data.hpp"
#include "engine/geometry/tangle/bounded_overlap.hpp"
#include "engine/geometry/tangle/running_sums.hpp"
#include "kernels/box.hpp"
#include "lober/base/error.hpp"
#include "lober/overlay/interior.hpp"

namespace lober {
using namespace detail;
namespace {

// The contribution of one crossing to the common area of lobe i and the moved lobe j.
struct CopyTerm {
  std::uint32_t i, j;
  DD twice{};
  double error = 0, length = 0;
  int rho = 0;
};

// The pips that crossings lie before, on both curves.
class HiddenPips {
 public:
  explicit HiddenPips(std::size_t pips) : changes_(pips + 1) {}
  /// Pips from `first` to `last`.
  void hide(std::int32_t first, std::int32_t last) {
    if (first > last) return;
    ++changes_[static_cast<std::size_t>(first)];
    --changes_[static_cast<std::size_t>(last) + 1];
  }
  [[nodiscard]] std::vector<std::uint32_t> numbers() const {
    std::vector<std::uint32_t> list;
    int depth = 0;
    for (std::uint32_t pip = 0; pip + 1 < changes_.size(); ++pip) {
      depth += changes_[pip];
      if (depth > 0) list.push_back(pip);
    }
    return list;
  }

 private:
  std::vector<int> changes_;
};

// The crossings of U with S moved by a vector.
class CrossingsOfCopy {
 public:
  CrossingsOfCopy(const Tangle& tangle, Point translation) : tangle_(tangle) {
    moved_.reserve(tangle.s().points.size());
    for (const Point point : tangle.s().points) moved_.push_back({point.x + translation.x, point.y + translation.y});
    // Where a copy begins at the other curve's saddle, at the same point to the bit: else they might cross there.
    const Point start = tangle.u().points.front();
    if (distance(moved_.front(), start) <= 1e-8 * (1 + std::hypot(start.x, start.y))) moved_.front() = start;
    curves_.smooth = tangle.curves->smooth;
    curves_.chords_u = tangle.curves->chords_u;
    curves_.chords_s = tangle.curves->chords_s;
    curves_.index_u = tangle.curves->u();
    curves_.index_s = IndexedCurve(CurveView{moved_, false});
    nodes_ = make_crossings(build_node_graph(curves_.u(), curves_.s(), choose_index(curves_.u(), curves_.s())),
                            curves_.u(), curves_.s(), Orientation::counter_clockwise, Orientation::counter_clockwise);
  }

  [[nodiscard]] const Crossings& nodes() const { return nodes_; }

  /// Each node's arcs; those beyond the pips are -1 or the last pip, as in ArcsAt.
  [[nodiscard]] std::vector<ArcsAt> arcs() const {
    const auto before = [](Position x, Position y) {
      return x.segment != y.segment ? x.segment < y.segment : x.t < y.t;
    };
    std::vector<ArcsAt> result(nodes_.size());
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      const Node node = nodes_[k];
      const std::vector<Pip>& pips = tangle_.pips;
      const auto u = std::upper_bound(pips.begin(), pips.end(), node.begin1,
                                      [&](Position at, const Pip& pip) { return before(at, pip.u); });
      // Along S pips come the other way round.
      const auto s = std::upper_bound(pips.rbegin(), pips.rend(), node.begin2,
                                      [&](Position at, const Pip& pip) { return before(at, pip.s); });
      result[k] = {static_cast<std::int32_t>(u - pips.begin()) - 1, static_cast<std::int32_t>(pips.rend() - s) - 1};
    }
    return result;
  }

  [[nodiscard]] std::vector<SumsToNode> sums(std::span<const std::uint32_t> nodes) const {
    return sums_to_nodes(curves_, nodes_, nodes);
  }

 private:
  const Tangle& tangle_;
  std::vector<Point> moved_;
  TangleCurves curves_;
  Crossings nodes_;
};

// The terms of U with moved S, or of moved U with S, which are those of U with S moved back.
void add_terms(const Tangle& tangle, Point translation, bool copy_is_of_s, std::vector<CopyTerm>& terms,
               HiddenPips& hidden) {
  const CrossingsOfCopy crossings(tangle, copy_is_of_s ? translation : Point{-translation.x, -translation.y});
  const std::vector<ArcsAt> arcs = crossings.arcs();
  const auto lobes = static_cast<std::int32_t>(tangle.lobes.size());
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t node = 0; node < arcs.size(); ++node) {
    const ArcsAt at = arcs[node];
    if (crossings.nodes().rho(node) == 0) continue;
    hidden.hide(at.u + 1, std::min(at.s, lobes));
    if (at.u >= 0 && at.s >= 0 && at.u < lobes && at.s < lobes) nodes.push_back(node);
  }
  const std::vector<SumsToNode> sums = crossings.sums(nodes);
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const ArcsAt at = arcs[nodes[k]];
    const auto u = static_cast<std::uint32_t>(at.u), s = static_cast<std::uint32_t>(at.s);
    const int o_u = tangle.lobes[u].orientation(), o_s = tangle.lobes[s].orientation();
    const int rho = crossings.nodes().rho(nodes[k]);
    CopyTerm term{.i = copy_is_of_s ? u : s, .j = copy_is_of_s ? s : u};
    term.twice = rho * o_u * o_s > 0 ? sums[k].gap : -sums[k].gap;
    term.error = rho * (o_s * sums[k].error_u - o_u * sums[k].error_s) + sums[k].uncertainty;
    term.length = rho * (o_s * sums[k].length_u - o_u * sums[k].length_s);
    term.rho = rho;
    terms.push_back(term);
  }
}

// A lobe that holds a fixed point, or a copy of one, holds whole lobes between there and itself.
void add_whole_lobes(const Tangle& tangle, Point translation, std::vector<CopyTerm>& terms) {
  const auto lobes = static_cast<std::uint32_t>(tangle.lobes.size());
  const Point p = tangle.u().points.front(), q = tangle.s().points.front();
  const auto moved = [&](Point point, double times) {
    return Point{point.x + times * translation.x, point.y + times * translation.y};
  };
  for (std::uint32_t m = 0; m < lobes; ++m) {
    const std::vector<Point> outline = lobe_outline(tangle, m);
    const Box box = box_of(outline);
    std::optional<IndexedCurve> index;
    const auto holds = [&](Point point) {
      if (!meet(Box::of(point, point), box)) return false;
      if (!index) index.emplace(CurveView{outline});
      return winding(*index, point).number != 0;
    };
    const auto whole = [&](std::uint32_t lobe, bool copy_is_smaller) {
      const double twice = std::fabs(tangle.lobes[lobe].area) * 2;
      terms.push_back({copy_is_smaller ? m : lobe,
                       copy_is_smaller ? lobe : m,
                       {twice, 0},
                       2 * tangle.lobes[lobe].smooth_error,
                       perimeter(lobe_outline(tangle, lobe))});
    };
    // In lobe m the copies of the fixed points, and in the copy of lobe m the fixed points themselves.
    for (const bool copy_is_smaller : {true, false}) {
      const double times = copy_is_smaller ? 1 : -1;
      if (holds(moved(p, times))) {
        for (std::uint32_t lobe = 0; lobe < m; ++lobe) whole(lobe, copy_is_smaller);
      }
      if (holds(moved(q, times))) {
        for (std::uint32_t lobe = m + 1; lobe < lobes; ++lobe) whole(lobe, copy_is_smaller);
      }
    }
  }
}

}  // namespace

CopyOverlaps overlaps_with_copy(const Tangle& tangle, Point translation) {
  if (translation == Point{}) throw UsageError("overlaps: the translation of the copy cannot be zero");
  CopyOverlaps result;
  if (tangle.pips.empty()) return result;
  if (tangle.curves->exponent != 0)
    throw DataError("overlaps: coordinates of this size are out of range for products; give them in another unit");
  std::vector<CopyTerm> terms;
  HiddenPips hidden(tangle.pips.size());
  for (const bool copy_is_of_s : {true, false}) add_terms(tangle, translation, copy_is_of_s, terms, hidden);
  const std::size_t of_crossings = terms.size();
  add_whole_lobes(tangle, translation, terms);
  const bool fixed_points_held = terms.size() > of_crossings;
  result.hidden_pips = hidden.numbers();
  std::stable_sort(terms.begin(), terms.end(),
                   [](const CopyTerm& x, const CopyTerm& y) { return x.i != y.i ? x.i < y.i : x.j < y.j; });
  // Points of the copy are rounded.
  const double rounded = 0x1p-52 * (box_of(tangle.u().points).extent() + length(translation));
  for (std::size_t k = 0; k < terms.size();) {
    CopyTerm sum{terms[k].i, terms[k].j};
    for (; k < terms.size() && terms[k].i == sum.i && terms[k].j == sum.j; ++k) {
      sum.twice += terms[k].twice;
      sum.error += terms[k].error;
      sum.length += terms[k].length;
      sum.rho += terms[k].rho;
    }
    const double area = tangle.curves->area(sum.twice), length_of_both = std::max(0.0, sum.length);
    const double error = tangle.curves->area({std::max(0.0, sum.error), 0}) + tangle.rounding(area);
    const LobeOverlap found{sum.i, sum.j, 0, error + rounded * length_of_both, length_of_both};
    result.overlaps.push_back(bounded(tangle, found, area, fixed_points_held || sum.rho == 0));
  }
  return result;
}

}  // namespace lober
