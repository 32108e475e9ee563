#include "engine/geometry/tangle/boundary.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/base/text.hpp"
#include "engine/geometry/crossings/crossings_data.hpp"
#include "engine/geometry/curve/require.hpp"
#include "engine/geometry/tangle/gaps.hpp"
#include "engine/geometry/tangle/lobe_topology.hpp"
#include "kernels/shoelace.hpp"
#include "lober/overlay/regions.hpp"

namespace lober::detail {
namespace {

// Where the closure meets a manifold, but where the manifold begins.
std::vector<Position> closure_meetings(const IndexedCurve& closure, const IndexedCurve& curve) {
  const Point start = curve.view().points[0];
  std::vector<Position> meetings;
  const ContactList contacts = find_contacts(closure, curve, IndexKind::tree).list;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const Contact contact = contacts[k];
    const auto points = curve.view().points.first(contact.segment2 + 1);
    const bool at_start = contact.vertex1 && contact.vertex2 &&
                          std::all_of(points.begin(), points.end(), [&](Point p) { return p == start; });
    if (!at_start) meetings.push_back({contact.segment2, contact.t2.hi});
  }
  return meetings;
}

// Whether the closure cuts the boundary, and which lobes it cuts.
struct ClosureCuts {
  bool boundary = false;
  std::vector<bool> lobes;
};
ClosureCuts cuts_of_closure(const Tangle& tangle) {
  ClosureCuts cuts{false, std::vector<bool>(tangle.lobes.size())};
  const TangleCurves& curves = *tangle.curves;
  const std::vector<Point> path = closing_path(tangle);
  if (path.size() == 2 && path[0] == path[1]) return cuts;
  const IndexedCurve closure({path, false});
  // Parameters are rounded: crossings that near to a pip count for both sides.
  constexpr double uncertainty = 1e-12;
  const auto not_after = [](Position x, Position y) {
    return x.segment != y.segment ? x.segment < y.segment : x.t <= y.t + uncertainty;
  };
  const Pip& bip = tangle.pips[tangle.boundary->bip];
  const auto mark = [&](const std::vector<Position>& meetings, Position Pip::*on) {
    const bool outward = on == &Pip::u;  // pips come the other way round along S
    const auto& pips = tangle.pips;
    for (const Position at : meetings) {
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
  mark(closure_meetings(closure, curves.u()), &Pip::u);
  mark(closure_meetings(closure, curves.s()), &Pip::s);
  return cuts;
}

double nonzero_area(const std::vector<Point>& polygon) {
  if (!bounds_something(polygon)) return 0;
  return regions(ClosedCurve::borrow(polygon)).areas(FillRule::nonzero).c1;
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

std::vector<Point> closing_path(const Tangle& tangle) {
  const TangleCurves& curves = *tangle.curves;
  std::vector<Point> path{curves.s().view().points[0]};
  for (const Point corner : tangle.closure)
    path.push_back({std::ldexp(corner.x, curves.exponent), std::ldexp(corner.y, curves.exponent)});
  path.push_back(curves.u().view().points[0]);
  return path;
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
  const ClosureCuts closure = cuts_of_closure(tangle);
  boundary.crosses_itself = closure.boundary;
  std::vector<Point> outline;  // made when it is needed
  const auto polygon = [&]() -> const std::vector<Point>& {
    if (outline.empty()) outline = boundary_outline(tangle);
    return outline;
  };
  boundary.area = boundary.crosses_itself ? nonzero_area(polygon()) : std::fabs(curves.area(twice_area));
  if (curves.smooth) {
    boundary.smooth_error = curves.area({tangle.pips[bip].gap_error, 0}) + tangle.rounding(boundary.area);
  }

  const BoundaryCrossings crossings = crossings_with_lobes(tangle);
  const Buffer<DD> gaps = gaps_at(curves, graph_of(tangle.nodes), crossings.nodes);
  std::vector<DD> sums(tangle.lobes.size());
  for (std::size_t k = 0; k < gaps.size(); ++k) {
    DD& sum = sums[crossings.lobes[k]];
    sum = tangle.nodes.rho(crossings.nodes[k]) > 0 ? sum + gaps[k] : sum - gaps[k];
  }
  std::vector<bool> crossed(tangle.lobes.size());
  for (const std::uint32_t lobe : crossings.lobes) crossed[lobe] = true;

  for (std::size_t m = 0; m < tangle.lobes.size(); ++m) {
    Lobe& lobe = tangle.lobes[m];
    const double area = std::fabs(lobe.area);
    lobe.meets_closure = closure.lobes[m];
    if (boundary.crosses_itself || lobe.meets_closure || holds_start_of_u(tangle, m) || holds_start_of_s(tangle, m)) {
      const double common = common_area(lobe_outline(tangle, m), polygon());
      const bool speck = common <= tangle.rounding(area);  // corners of outlines are rounded
      lobe.inside = speck ? 0 : std::min(area, common);
      lobe.outside = area - lobe.inside;
      continue;
    }
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
}

}  // namespace lober::detail
