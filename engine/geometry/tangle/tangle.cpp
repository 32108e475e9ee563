#include "lober/tangle/tangle.hpp"

#include <algorithm>
#include <cmath>

#include "engine/base/stopwatch.hpp"
#include "engine/geometry/crossings/crossings_data.hpp"
#include "engine/geometry/crossings/require_simple.hpp"
#include "engine/geometry/curve/require.hpp"
#include "engine/geometry/index/sums_along.hpp"
#include "engine/geometry/smooth/smooth_gaps.hpp"
#include "engine/geometry/tangle/boundary.hpp"
#include "engine/geometry/tangle/closing_path.hpp"
#include "engine/geometry/tangle/gaps.hpp"
#include "engine/geometry/tangle/images.hpp"
#include "engine/geometry/tangle/lobe_topology.hpp"
#include "engine/geometry/tangle/pips.hpp"

namespace lober {
using namespace detail;
namespace {

void sum_chords(TangleCurves& curves) {
  curves.chords_u = std::make_shared<const ChordAreaTable>(SmoothCurve(curves.u().view()));
  curves.chords_s = std::make_shared<const ChordAreaTable>(SmoothCurve(curves.s().view()));
}

// The curves at a scale where products stay in range; at that of the given indexes whenever possible.
std::shared_ptr<const TangleCurves> scaled_curves(const IndexedCurve& u, const IndexedCurve& s, bool smooth) {
  if (!u.tree().sums_finite()) validate(u.view(), "U");
  if (!s.tree().sums_finite()) validate(s.view(), "S");
  auto curves = std::make_shared<TangleCurves>();
  curves->exponent = scaling_exponent(union_of(u.tree().box(), s.tree().box()));
  curves->smooth = smooth;
  if (curves->exponent == 0) {
    curves->index_u = u;
    curves->index_s = s;
  } else {
    curves->scaled_u = scaled(u.view(), curves->exponent);
    curves->scaled_s = scaled(s.view(), curves->exponent);
    curves->index_u.emplace(CurveView{curves->scaled_u, false});
    curves->index_s.emplace(CurveView{curves->scaled_s, false});
  }
  if (smooth) sum_chords(*curves);
  return curves;
}

void set_gap(Pip& pip, DD gap) {
  pip.gap = gap.hi;
  pip.gap_low = gap.lo;
}

// Moves the pips, and the areas of the lobes with them, to where the smooth curves have them.
void smooth_lobes(Tangle& tangle) {
  const TangleCurves& curves = *tangle.curves;
  std::vector<std::uint32_t> nodes;
  for (const Pip& pip : tangle.pips) nodes.push_back(pip.node);
  const SmoothGaps smooth = curves.smooth_gaps_at(graph_of(tangle.nodes), nodes);
  tangle.fallback_segments = smooth.fallback_segments;
  tangle.fallback_pips = smooth.fallback_crossings;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const Point at = smooth.at[k].at;
    tangle.pips[k].at = {std::ldexp(at.x, -curves.exponent), std::ldexp(at.y, -curves.exponent)};
    set_gap(tangle.pips[k], gap_of(tangle.pips[k]) + smooth.at[k].twice);
    tangle.pips[k].gap_error = smooth.at[k].error1 + smooth.at[k].error2 + smooth.at[k].uncertainty;
  }
  for (std::size_t k = 0; k < tangle.lobes.size(); ++k) {
    const SmoothGap &first = smooth.at[k], &last = smooth.at[k + 1];
    const double error =
        last.error1 - first.error1 + (first.error2 - last.error2) + first.uncertainty + last.uncertainty;
    tangle.lobes[k].area = curves.area(gap_of(tangle.pips[k + 1]) - gap_of(tangle.pips[k]));
    tangle.lobes[k].smooth_error = curves.area({error, 0}) + tangle.rounding(tangle.lobes[k].area);
  }
}

// How many pips there would be if one of the curves, or both, were given from the other end.
void remark_direction(Tangle& tangle) {
  constexpr std::size_t fewest = 5, times = 3;
  const std::size_t suspicious = std::max(fewest, times * tangle.pips.size());
  if (tangle.nodes.crossings() < suspicious) return;
  const auto remark = [&](const char* which, std::size_t pips) {
    if (pips < suspicious) return;
    tangle.remarks.push_back(std::string(which) + " given inward? The other way round there would be " +
                             std::to_string(pips) + " pips instead of " + std::to_string(tangle.pips.size()));
  };
  remark("is U", find_pips(tangle.nodes, true, false).size());
  remark("is S", find_pips(tangle.nodes, false, true).size());
  remark("are U and S", find_pips(tangle.nodes, true, true).size());
}

// The curves are OpenCurve, or indexed already.
template <typename Given>
Tangle find_tangle(const Given& given_u, const Given& given_s, const TangleOptions& options) {
  const auto report = [&](double fraction) {
    if (!options.progress(fraction)) throw Cancelled();
  };
  const Stopwatch watch;
  Tangle result;
  report(0);
  // NOLINTNEXTLINE(performance-unnecessary-copy-initialization): copies of an index share it
  const IndexedCurve u(given_u), s(given_s);
  result.curves = scaled_curves(u, s, options.smooth);
  result.closure = options.closure;
  for (const Point corner : result.closure) {
    if (!std::isfinite(corner.x) || !std::isfinite(corner.y))
      throw DataError("tangle: a corner of the closure is not finite");
  }
  const TangleCurves& curves = *result.curves;
  result.timing.index = watch.seconds();
  if (options.check_simple) {
    for (const SimpleCheck& check : {require_simple_scaled(curves.u(), 1, curves.exponent),
                                     require_simple_scaled(curves.s(), 2, curves.exponent)}) {
      result.check_simple.search += check.search;
      result.check_simple.pairs += check.pairs;
    }
  }
  result.timing.check = watch.seconds() - result.timing.index;
  report(0.3);
  result.index = options.index == IndexKind::automatic ? choose_index(curves.u(), curves.s()) : options.index;
  NodeGraph graph = build_node_graph(curves.u(), curves.s(), result.index);
  result.timing.crossings = graph.search_seconds;
  result.timing.order = graph.order_seconds;
  report(0.8);

  const Stopwatch area_watch;
  result.nodes = make_crossings(std::move(graph), u, s, Orientation::counter_clockwise, Orientation::counter_clockwise);
  const std::vector<std::uint32_t> pips = find_pips(result.nodes);
  const Buffer<DD> gaps = polygon_gaps_at(curves, graph_of(result.nodes), pips);
  for (std::size_t k = 0; k < pips.size(); ++k) {
    const Node node = result.nodes[pips[k]];
    result.pips.push_back({pips[k], node.begin, node.begin1, node.begin2, node.rho, gaps[k].hi, gaps[k].lo});
  }
  for (std::size_t k = 0; k + 1 < pips.size(); ++k) {
    result.lobes.emplace_back();
    result.lobes.back().area = result.lobes.back().polygon_area = curves.area(gaps[k + 1] - gaps[k]);
  }
  if (options.smooth && !pips.empty()) smooth_lobes(result);
  // Who names the bip by its number and the period knows the pips, as those do who grew the manifolds.
  if (!options.bip || options.period == 0) remark_direction(result);
  result.timing.pips = area_watch.seconds();
  if (pips.empty()) {
    if (options.bip || options.bip_near) throw UsageError("a bip is given, but the manifolds do not cross");
    const auto first = u.view().points, second = s.view().points;
    result.remarks.emplace_back(std::equal(first.begin(), first.end(), second.begin(), second.end()) ||
                                        std::equal(first.begin(), first.end(), second.rbegin(), second.rend())
                                    ? "U and S are one and the same curve: no pip, no lobe, no boundary"
                                    : "the manifolds do not cross: no pip, no lobe, no boundary");
  } else {
    if (pips.size() == 1) result.remarks.emplace_back("one pip only: a boundary, but no lobe");
    result.boundary = Boundary{.bip = choose_bip(result, options)};
    if (result.nodes.touches() + result.nodes.shared_arcs() > 0) mark_pinched_lobes(result);
    if (options.parts) bound_lobes(result);
  }
  result.images = find_images(result, options.period);
  result.timing.areas = area_watch.seconds() - result.timing.pips;
  result.timing.total = watch.seconds();
  report(1);
  return result;
}

}  // namespace

double Tangle::rounding(double area) const {
  Box box = union_of(curves->u().tree().box(), curves->s().tree().box());
  for (const Point corner : closing_path(*this)) box = union_of(box, Box::of(corner, corner));
  const double lost = lost_in_sums(box.extent(), nodes.size(), u().segments() + s().segments() + closure.size());
  if (curves->exponent == 0) return std::fabs(area) * 0x1p-53 + lost;
  return std::fabs(area) * 0x1p-53 + scaled_bound(lost, -2 * curves->exponent);
}

Tangle tangle(const OpenCurve& u, const OpenCurve& s, const TangleOptions& options) {
  require_enough_vertices(u, "U");
  require_enough_vertices(s, "S");
  return find_tangle(u, s, options);
}

Tangle tangle(const IndexedCurve& u, const IndexedCurve& s, const TangleOptions& options) {
  require_open(u.view(), "U", "tangle");
  require_open(s.view(), "S", "tangle");
  require_enough_vertices(u.view(), "U");
  require_enough_vertices(s.view(), "S");
  return find_tangle(u, s, options);
}

}  // namespace lober
