#include "engine/geometry/tangle/boundary.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/base/text.hpp"
#include "engine/geometry/crossings/crossings_data.hpp"
#include "engine/geometry/curve/require.hpp"
#include "engine/geometry/smooth/beyond_path.hpp"
#include "engine/geometry/tangle/closing_path.hpp"
#include "engine/geometry/tangle/gaps.hpp"
#include "engine/geometry/tangle/lobe_topology.hpp"
#include "engine/geometry/tangle/winding_sums.hpp"
#include "kernels/shoelace.hpp"
#include "lober/overlay/regions.hpp"

namespace lober::detail {
namespace {

double nonzero_area(const std::vector<Point>& polygon) {
  if (!bounds_something(polygon)) return 0;
  return regions(ClosedCurve::borrow(polygon)).areas(FillRule::nonzero).c1;
}

// Whether the closure cuts the boundary, and which lobes it cuts.
struct ClosureCuts {
  bool boundary = false;
  std::vector<bool> lobes;
};
ClosureCuts cuts_of_closure(const Tangle& tangle, const ClosingPath& closure) {
  ClosureCuts cuts{false, std::vector<bool>(tangle.lobes.size())};
  if (!closure.has_length()) return cuts;
  if (closure.meets_itself() || closure.is_loop()) {
    // It may only touch itself, or go some way and come back; a loop may lie round the rest, or turn the other way.
    constexpr double negligible = 1e-12;
    const std::vector<Point> outline = boundary_outline(tangle);
    const double wound = nonzero_area(outline);
    const double enclosed = std::fabs(signed_area(CurveView{outline, true}));
    cuts.boundary = std::fabs(wound - enclosed) > negligible * std::max(wound, enclosed);
  }
  // Parameters are rounded: crossings that near to a pip count for both sides.
  constexpr double uncertainty = 1e-12;
  const auto not_after = [](Position x, Position y) {
    return x.segment != y.segment ? x.segment < y.segment : x.t <= y.t + uncertainty;
  };
  const Pip& bip = tangle.pips[tangle.boundary->bip];
  const auto mark = [&](const IndexedCurve& manifold, const ContactList& contacts, Position Pip::*on) {
    const bool outward = on == &Pip::u;  // pips come the other way round along S
    const auto& pips = tangle.pips;
    for (std::size_t number = 0; number < contacts.size(); ++number) {
      const Contact contact = contacts[number];
      if (ClosingPath::at_start(manifold, contact)) continue;
      const Position at{contact.segment1, contact.t1.hi};
      cuts.boundary = cuts.boundary || not_after(at, bip.*on);
      // A lobe is cut unless both its pips lie before the position or both behind it.
      const auto ended = std::partition_point(pips.begin(), pips.end(), [&](const Pip& pip) {
        return outward ? !not_after(at, pip.*on) : !not_after(pip.*on, at);
      });
      const auto begun = std::partition_point(pips.begin(), pips.end(), [&](const Pip& pip) {
        return outward ? not_after(pip.*on, at) : not_after(at, pip.*on);
      });
      const auto from = static_cast<std::size_t>(std::max<std::ptrdiff_t>(ended - pips.begin() - 1, 0));
      const auto to = std::min(static_cast<std::size_t>(begun - pips.begin()), cuts.lobes.size());
      for (std::size_t k = from; k < to; ++k) cuts.lobes[k] = true;
    }
  };
  mark(tangle.curves->u(), closure.on_u().contacts, &Pip::u);
  mark(tangle.curves->s(), closure.on_s().contacts, &Pip::s);
  return cuts;
}

double common_area(const std::vector<Point>& first, const std::vector<Point>& second) {
  if (!bounds_something(first) || !bounds_something(second)) return 0;
  return regions(ClosedCurve::borrow(first), ClosedCurve::borrow(second)).areas(FillRule::nonzero).intersection;
}

// The crossings of the boundary with lobes: node numbers, and for each the lobe it is on.
struct BoundaryCrossings {
  std::vector<std::uint32_t> nodes, lobes;
};
BoundaryCrossings crossings_with_lobes(const Tangle& tangle) {
  const auto bip = static_cast<std::int32_t>(tangle.boundary->bip);
  const auto lobes = static_cast<std::int32_t>(tangle.lobes.size());
  const std::vector<ArcsAt> arcs = arcs_at_nodes(tangle);
  BoundaryCrossings found;
  for (std::uint32_t node = 0; node < arcs.size(); ++node) {
    const ArcsAt at = arcs[node];
    if (tangle.nodes.rho(node) == 0 || at.generation() == 0) continue;
    std::int32_t lobe = -1;
    if (at.u >= bip && at.s >= bip && at.u < lobes) lobe = at.u;
    if (at.u < bip && at.s >= 0) lobe = at.s;  // then at.s < at.u < bip
    if (lobe < 0) continue;
    found.nodes.push_back(node);
    found.lobes.push_back(static_cast<std::uint32_t>(lobe));
  }
  return found;
}

// Where the smooth arcs of some segments of a curve lie, the segments have been: twice the area between, from above.
double twice_between(const CurveView& view, std::uint32_t from, std::uint32_t to) {
  constexpr std::uint32_t beyond = 2;  // segments by which a crossing may have moved (smooth_crossing.cpp)
  constexpr int samples = 8;
  const SmoothCurve curve(view);
  const auto first = static_cast<std::int64_t>(from > beyond ? from - beyond : 0);
  const auto last = std::min(static_cast<std::int64_t>(to) + beyond + 1, static_cast<std::int64_t>(curve.segments()));
  double twice = 0;
  for (std::int64_t k = first; k < last; ++k) {
    const SmoothSegment segment = curve.segment(k);
    double height = 0;
    for (int j = 0; j < samples; ++j) height += std::fabs(segment.f_at((j + 0.5) / samples));
    twice += 2 * height / samples * dot(segment.chord, segment.chord) + 2 * segment.error;
  }
  return twice;
}

// Twice the area, from above, that smooth arcs of the manifolds have beyond the closure where their polygons do not
// meet it: of those that bound lobes or the boundary.
double twice_hidden_at(const ClosingPath& closure, const Tangle& tangle) {
  if (!closure.has_length()) return 0;
  const auto hidden_along = [&](const IndexedCurve& whole, Position last) {
    constexpr std::size_t moves_by = 2, fitted_beside = 8;  // smooth_crossing.cpp
    const std::size_t segments = std::min(last.segment + 1 + moves_by, whole.segments());
    const std::size_t points = std::min(whole.view().points.size(), segments + fitted_beside);
    return twice_beyond_path(SmoothCurve(CurveView{whole.view().points.first(points), false}), closure.points(),
                             segments);
  };
  return hidden_along(tangle.curves->u(), tangle.pips.back().u) +
         hidden_along(tangle.curves->s(), tangle.pips.front().s);
}

// The parts of a lobe and the boundary by their polygons, where the path that closes the boundary is in the way of sums
// up to crossings; of smooth curves then what they add to that.
class Overlaid {
 public:
  Overlaid(const Tangle& tangle, const ClosingPath& closure) : tangle_(tangle), closure_(closure) {}

  [[nodiscard]] Measured boundary() {
    const double polygons = nonzero_area(outline());
    return smooth(
        polygons, [&] { return between_boundary(); }, [&] { return sums().boundary(polygons); });
  }
  [[nodiscard]] Measured inside(std::size_t lobe) {
    const double common = common_area(lobe_outline(tangle_, lobe), outline());
    const Pip &first = tangle_.pips[lobe], &last = tangle_.pips[lobe + 1];
    const auto both = [&] { return between_boundary() + between(first.u, last.u, last.s, first.s); };
    return smooth(common, both, [&] { return sums().inside(lobe, common); });
  }
  /// Whether polygons stood for smooth curves.
  [[nodiscard]] bool of_polygons() const { return of_polygons_; }

 private:
  const std::vector<Point>& outline() {
    if (outline_.empty()) outline_ = boundary_outline(tangle_);
    return outline_;
  }
  const WindingSums& sums() {
    if (!sums_) sums_.emplace(tangle_, closure_);
    return *sums_;
  }
  template <typename Between, typename Find>
  [[nodiscard]] Measured smooth(double polygons, const Between& between, const Find& find) {
    if (!tangle_.curves->smooth) return {polygons, 0};
    if (const std::optional<Measured> found = find()) return *found;
    of_polygons_ = true;
    return {polygons, between() + tangle_.rounding(polygons)};
  }
  double between_boundary() {
    if (!between_boundary_) {
      const Pip& bip = tangle_.pips[tangle_.boundary->bip];
      between_boundary_ = between({}, bip.u, {}, bip.s);
    }
    return *between_boundary_;
  }
  [[nodiscard]] double between(Position u_from, Position u_to, Position s_from, Position s_to) const {
    const TangleCurves& curves = *tangle_.curves;
    if (!curves.smooth) return 0;
    return curves.area({twice_between(curves.u().view(), u_from.segment, u_to.segment) +
                            twice_between(curves.s().view(), s_from.segment, s_to.segment),
                        0});
  }

  const Tangle& tangle_;
  const ClosingPath& closure_;
  std::vector<Point> outline_;  // made when it is needed, as are the others
  std::optional<WindingSums> sums_;
  std::optional<double> between_boundary_;
  bool of_polygons_ = false;
};

}  // namespace

std::size_t choose_bip(const Tangle& tangle, const TangleOptions& options) {
  const std::vector<Pip>& pips = tangle.pips;
  if (options.bip && options.bip_near)
    throw UsageError("the bip is given twice, by number and by position; give one of them");
  if (options.bip) {
    if (*options.bip >= pips.size()) {
      throw UsageError("there is no pip " + std::to_string(*options.bip) + ": they are numbered 0 to " +
                       std::to_string(pips.size() - 1));
    }
    return *options.bip;
  }
  if (!options.bip_near) return pips.size() / 2;
  const Point asked = *options.bip_near;
  const auto nearest = std::min_element(pips.begin(), pips.end(), [&](const Pip& x, const Pip& y) {
    return distance(x.at, asked) < distance(y.at, asked);
  });
  const double far =
      std::max(distance(nearest->at, tangle.u().points.front()), distance(nearest->at, tangle.s().points.front()));
  if (distance(nearest->at, asked) > far) {
    throw UsageError("no pip lies near the bip asked for, " + format_point(asked) + ": the nearest one is " +
                     format_point(nearest->at) + ", which is nearer to where the manifolds begin");
  }
  return static_cast<std::size_t>(nearest - pips.begin());
}

DD twice_swept(const Tangle& tangle, std::size_t pip) {
  DD twice = gap_of(tangle.pips.at(pip));  // about p-, so that a chord adds nothing
  const std::vector<Point> path = closing_path(tangle);
  for (std::size_t k = 1; k < path.size(); ++k) twice += shoelace(path[k - 1], path[k], tangle.curves->origin());
  return twice;
}

void bound_lobes(Tangle& tangle) {
  Boundary& boundary = *tangle.boundary;
  const TangleCurves& curves = *tangle.curves;
  const std::size_t bip = boundary.bip;
  const DD twice_area = twice_swept(tangle, bip);
  boundary.orientation = twice_area.hi < 0 ? -1 : 1;
  const ClosingPath closure(tangle);
  const ClosureCuts cuts = cuts_of_closure(tangle, closure);
  boundary.crosses_itself = cuts.boundary;
  Overlaid overlaid(tangle, closure);
  if (boundary.crosses_itself) {
    const Measured found = overlaid.boundary();
    boundary.area = found.value;
    boundary.smooth_error = found.error;
  } else {
    boundary.area = std::fabs(curves.area(twice_area));
    if (curves.smooth)
      boundary.smooth_error = curves.area({tangle.pips[bip].gap_error, 0}) + tangle.rounding(boundary.area);
  }

  const BoundaryCrossings crossings = crossings_with_lobes(tangle);
  Buffer<DD> gaps = polygon_gaps_at(curves, graph_of(tangle.nodes), crossings.nodes);
  std::vector<DD> sums(tangle.lobes.size());
  // Twice the errors of the boundary's arcs in each lobe, with a sign, and of the crossings.
  std::vector<double> arcs(tangle.lobes.size()), uncertainty(tangle.lobes.size());
  if (curves.smooth && !crossings.nodes.empty()) {
    const SmoothGaps smooth = curves.smooth_gaps_at(graph_of(tangle.nodes), crossings.nodes);
    for (std::size_t k = 0; k < gaps.size(); ++k) {
      const SmoothGap& gap = smooth.at[k];
      const std::uint32_t lobe = crossings.lobes[k];
      gaps[k] += gap.twice;
      arcs[lobe] += tangle.nodes.rho(crossings.nodes[k]) * (lobe >= bip ? gap.error2 : gap.error1);
      uncertainty[lobe] += gap.uncertainty;
    }
  }
  for (std::size_t k = 0; k < gaps.size(); ++k) {
    DD& sum = sums[crossings.lobes[k]];
    sum = tangle.nodes.rho(crossings.nodes[k]) > 0 ? sum + gaps[k] : sum - gaps[k];
  }
  std::vector<bool> crossed(tangle.lobes.size());
  for (const std::uint32_t lobe : crossings.lobes) crossed[lobe] = true;

  for (std::size_t m = 0; m < tangle.lobes.size(); ++m) {
    Lobe& lobe = tangle.lobes[m];
    const double area = std::fabs(lobe.area);
    lobe.meets_closure = cuts.lobes[m];
    if (boundary.crosses_itself || lobe.meets_closure || holds_start_of_u(tangle, m) || holds_start_of_s(tangle, m)) {
      const Measured common = overlaid.inside(m);
      const bool speck = common.value <= tangle.rounding(area);  // corners of outlines are rounded
      lobe.inside = speck ? 0 : std::min(area, common.value);
      lobe.outside = area - lobe.inside;
      // It is known to be no less than nothing, and no more than the lobe.
      const double beyond = std::max({-common.value, common.value - area, 0.0});
      if (curves.smooth) lobe.boundary_error = common.error + beyond;
      continue;
    }
    lobe.boundary_error = curves.area({std::fabs(arcs[m]) + uncertainty[m], 0});
    const int relative_orientation = lobe.orientation() * boundary.orientation;
    const bool begins_inside = relative_orientation == (m >= bip ? -1 : 1);
    if (!crossed[m]) {
      (begins_inside ? lobe.inside : lobe.outside) = area;
      continue;
    }
    const DD signed_twice = gap_of(tangle.pips[m + 1]) - gap_of(tangle.pips[m]);
    const DD twice = lobe.orientation() > 0 ? signed_twice : -signed_twice;
    const DD part = relative_orientation == (m >= bip ? -1 : 1) ? sums[m] : -sums[m];
    // Along the shared arc the lobe is inside or outside; the crossings take away from that or add to it.
    lobe.inside = std::clamp(curves.area(begins_inside ? twice + part : part), 0.0, area);
    lobe.outside = std::clamp(curves.area(begins_inside ? -part : twice - part), 0.0, area);
  }
  if (curves.smooth) {
    const double hidden = curves.area({twice_hidden_at(closure, tangle), 0});
    boundary.smooth_error += hidden;
    for (Lobe& lobe : tangle.lobes) lobe.boundary_error += hidden;
  }
  boundary.of_polygons = overlaid.of_polygons();
  if (boundary.of_polygons) {
    tangle.remarks.emplace_back(
        "the polygons leave it open how smooth curves lie where the path that closes the boundary meets the manifolds: "
        "the areas of the boundary and of the parts of lobes there are those of polygons, with error bars for what "
        "lies between; a path of corners that keeps away from the manifolds avoids it");
  }
}

}  // namespace lober::detail
