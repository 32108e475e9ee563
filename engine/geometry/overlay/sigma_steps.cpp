// sigma, its classes and S, from the order of the crossings along both curves.

#include <algorithm>
#include <vector>

#include "engine/geometry/index/box_tree.hpp"
#include "kernels/shoelace.hpp"
#include "lober/base/error.hpp"
#include "lober/overlay/overlay.hpp"

namespace lober {
using namespace detail;
namespace {

// A crossing where it begins along C1: of a shared arc the same end on both curves, so that a boundary made of such
// arcs is closed.
struct Stop {
  std::uint32_t node;
  Position at;
  Point point;
};

// The integral of x dy - y dx from each stop to the next one as the vertices run; from the last one round to the first.
std::vector<DD> arcs_between(const CurveView& curve, const std::vector<Stop>& stops) {
  std::vector<DD> arcs(stops.size());
  for (std::size_t k = 0; k < stops.size(); ++k) {
    const Stop& from = stops[k];
    const Stop& to = stops[k + 1 == stops.size() ? 0 : k + 1];
    const std::size_t size = curve.points.size(), end = to.at.segment + std::size_t{1};
    const bool wraps = k + 1 == stops.size();
    DD sum{};
    Point last = from.point;
    const auto walk = [&](std::size_t begin, std::size_t until) {
      for (std::size_t vertex = begin; vertex < until; ++vertex) {
        sum += shoelace(last, curve.points[vertex], Point{});
        last = curve.points[vertex];
      }
    };
    if (wraps) {
      walk(from.at.segment + std::size_t{1}, size);
      walk(0, std::min(end, size));
    } else {
      walk(from.at.segment + std::size_t{1}, std::min(end, size));
    }
    sum += shoelace(last, to.point, Point{});
    arcs[k] = sum;
  }
  return arcs;
}

// The crossings along one curve, and from each of them its neighbours and the arcs to them.
struct NeighboursAlong {
  std::vector<std::uint32_t> next, previous;  // by number among the crossings
  std::vector<double> to_next, to_previous;   // integrals of x dy - y dx
};
NeighboursAlong neighbours_along(const CurveView& curve, std::vector<Stop> stops,
                                 const std::vector<std::uint32_t>& number, bool clockwise) {
  const std::vector<DD> arcs = arcs_between(curve, stops);
  const std::size_t size = stops.size();
  NeighboursAlong result{std::vector<std::uint32_t>(size), std::vector<std::uint32_t>(size), std::vector<double>(size),
                         std::vector<double>(size)};
  for (std::size_t k = 0; k < size; ++k) {
    const std::size_t after = k + 1 == size ? 0 : k + 1;
    const std::uint32_t from = number[stops[k].node], to = number[stops[after].node];
    const double arc = arcs[k].hi + arcs[k].lo;
    (clockwise ? result.previous : result.next)[from] = to;
    (clockwise ? result.next : result.previous)[to] = from;
    (clockwise ? result.to_previous : result.to_next)[from] = arc;
    (clockwise ? result.to_next : result.to_previous)[to] = 0 - arc;  // no -0
  }
  return result;
}

}  // namespace

std::vector<SigmaStep> sigma_steps(const Overlay& result, Pairing pairing) {
  if (pairing != Pairing::c1_minus_c2 && pairing != Pairing::c2_minus_c1) {
    throw UsageError("sigma_steps takes the pairings A1 \\ A2 and A2 \\ A1 only");
  }
  const Crossings& nodes = result.nodes;
  std::vector<Stop> stops1, stops2;
  std::vector<std::uint32_t> number(nodes.size());  // numbers of the crossings, by node
  std::vector<SigmaStep> steps;
  for (std::uint32_t node = 0; node < nodes.size(); ++node) {
    const Node here = nodes[node];
    if (here.rho == 0) continue;
    number[node] = static_cast<std::uint32_t>(steps.size());
    steps.push_back({.crossing = node, .rho = here.rho});
    stops1.push_back({node, here.begin1, here.begin});
  }
  if (steps.empty()) return steps;
  for (const std::uint32_t node : nodes.order2()) {
    const Node here = nodes[node];
    if (here.rho != 0) stops2.push_back({node, here.begin2, here.begin});
  }
  // A shared arc that holds the first vertex of C2 may begin, along C1, behind it. Else they are in order, also where
  // rounded parameters are equal.
  std::stable_sort(stops2.begin(), stops2.end(), [](const Stop& a, const Stop& b) {
    return a.at.segment != b.at.segment ? a.at.segment < b.at.segment : a.at.t < b.at.t;
  });
  const NeighboursAlong along1 = neighbours_along(nodes.curve1(), stops1, number, nodes.clockwise1());
  const NeighboursAlong along2 = neighbours_along(nodes.curve2(), stops2, number, nodes.clockwise2());
  const bool forward1 = pairing == Pairing::c1_minus_c2;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    SigmaStep& step = steps[k];
    const std::uint32_t next1 = (forward1 ? along1.next : along1.previous)[k];
    const std::uint32_t next2 = (forward1 ? along2.previous : along2.next)[k];
    step.along1 = steps[next1].crossing;
    step.along2 = steps[next2].crossing;
    step.sigma = step.rho > 0 ? step.along1 : step.along2;
    step.s = step.rho > 0 ? (forward1 ? along1.to_next : along1.to_previous)[k]
                          : (forward1 ? along2.to_previous : along2.to_next)[k];
    step.class_number = Overlay::no_class;
  }
  std::uint32_t classes = 0;
  for (SigmaStep& start : steps) {
    if (start.class_number != Overlay::no_class) continue;
    for (SigmaStep* step = &start; step->class_number == Overlay::no_class; step = &steps[number[step->sigma]]) {
      step->class_number = classes;
    }
    ++classes;
  }
  return steps;
}

}  // namespace lober
