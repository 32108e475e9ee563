#include "engine/dynamics/transport/tangles/barrier.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "engine/base/text.hpp"
#include "engine/dynamics/maps/plane.hpp"
#include "kernels/box.hpp"
#include "lober/base/error.hpp"
#include "lober/curve/curve.hpp"
#include "lober/overlay/smooth.hpp"

namespace lober::detail {
namespace {

// Length of the segments of a closed polygon that meet a box.
double length_in(const std::vector<Point>& polygon, const Box& box) {
  double length = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point a = polygon[k], b = polygon[k + 1 == polygon.size() ? 0 : k + 1];
    if (meet(Box::of(a, b), box)) length += distance(a, b);
  }
  return length;
}

Box intersection(const Box& a, const Box& b) {
  Box both;
  for (std::size_t k = 0; k < 4; ++k) both.lane[k] = std::max(a.lane[k], b.lane[k]);
  return both;
}

// Also more than once.
double whole_turns(const Barrier& barrier) {
  if (barrier.lattice == Point{}) return 0;
  const Point from = barrier.tangle->u().points.front(), to = barrier.tangle->s().points.front();
  const Point between{to.x - from.x, to.y - from.y};
  const double period = length(barrier.lattice);
  const double turns = std::round(along_and_above(barrier.lattice, between).x / period);
  const Point off{between.x - turns * barrier.lattice.x, between.y - turns * barrier.lattice.y};
  return length(off) > 1e-6 * period ? 0 : turns;
}

}  // namespace

Barrier barrier_of(const ManifoldTangle& manifolds, Point lattice) {
  Barrier barrier;
  barrier.tangle = &manifolds.tangle;
  barrier.bip = manifolds.bip;
  barrier.period = manifolds.period();
  barrier.errors_u = manifolds.point_errors_u;
  barrier.errors_s = manifolds.point_errors_s;
  barrier.lattice = lattice;
  barrier.fine = box_of(manifolds.fine);
  barrier.true_size = box_of(manifolds.true_size);
  return barrier;
}

int turns_of(const Barrier& barrier) {
  const double turns = whole_turns(barrier);
  if (turns == 0) return 0;
  if (std::fabs(turns) > 1) {
    throw DataError("transport: the saddles " + format_point(barrier.tangle->u().points.front()) + " and " +
                    format_point(barrier.tangle->s().points.front()) + " are " + format_number(std::fabs(turns)) +
                    " periods apart, so that the boundary crosses itself on the cylinder; take copies of them that are "
                    "next to each other");
  }
  return turns > 0 ? 1 : -1;
}

int sign_of(const Barrier& barrier) {
  // The inside is the region below, which is on the right of a curve along the lattice.
  if (const int turns = turns_of(barrier); turns != 0) return -turns;
  return swept_area(*barrier.tangle, barrier.bip).area < 0 ? -1 : 1;
}

std::vector<Point> outline_of(const Barrier& barrier, int k) {
  const std::size_t pip = barrier.pip(k);
  std::vector<Point> points = boundary_arcs(*barrier.tangle, pip);
  // The corner is where the smooth curves cross, if they do, not where their polygons do.
  const Point corner = barrier.tangle->nodes[barrier.tangle->pips[pip].node].begin;
  const auto at = std::find(points.begin() + barrier.tangle->pips[pip].u.segment, points.end(), corner);
  if (at != points.end()) *at = barrier.tangle->pips[pip].at;
  if (turns_of(barrier) == 0)
    points.insert(points.end(), barrier.tangle->closure.begin(), barrier.tangle->closure.end());
  return points;
}

double error_at_corner(const Barrier& barrier, int k) {
  const Pip& pip = barrier.tangle->pips[barrier.pip(k)];
  const std::span<const Point> u = barrier.tangle->u().points, s = barrier.tangle->s().points;
  if (pip.u.segment < 1 || pip.s.segment < 1) return 0;
  const std::array<Point, 5> around{u[pip.u.segment - 1], u[pip.u.segment], pip.at, s[pip.s.segment],
                                    s[pip.s.segment - 1]};
  std::array<double, 3> turns{};
  double longest = 0;
  for (std::size_t j = 0; j < 3; ++j) {
    const Point in = around[j + 1] - around[j], out = around[j + 2] - around[j + 1];
    const double lengths = length(in) * length(out);
    if (!(lengths > 0)) return 0;
    turns[j] = cross(in, out) / lengths;
    if (j > 0) longest = std::max(longest, length(in));
  }
  constexpr double seen_as_corner = 8;  // kernels/smooth_segment.hpp
  if (std::fabs(turns[1]) > seen_as_corner * std::max(std::fabs(turns[0]), std::fabs(turns[2]))) return 0;
  // A turn by that angle within a segment, of which the arc keeps a sixth of the square beside it.
  return std::fabs(turns[1] - (turns[0] + turns[2]) / 2) * longest * longest / 6;
}

bool closure_is_crossed(const Barrier& barrier, int k) {
  if (turns_of(barrier) != 0) return false;
  std::vector<Point> path{barrier.tangle->s().points[0]};
  path.insert(path.end(), barrier.tangle->closure.begin(), barrier.tangle->closure.end());
  path.push_back(barrier.tangle->u().points[0]);
  if (path.size() == 2 && path[0] == path[1]) return false;
  const std::vector<Point> line = boundary_arcs(*barrier.tangle, barrier.pip(k));
  const Point start = path.back(), end = path.front();
  const IndexedCurve closing(OpenCurve::borrow(path)), manifolds(OpenCurve::borrow(line));
  const std::vector<CommonPoint> common = common_points(closing, manifolds);
  return std::any_of(common.begin(), common.end(), [&](const CommonPoint& point) {
    return !(point.vertex1 && point.vertex2 && (point.at == start || point.at == end));
  });
}

bool crosses_itself(const Barrier& barrier) {
  const std::optional<Boundary>& boundary = barrier.tangle->boundary;
  return boundary && boundary->bip == barrier.bip && boundary->crosses_itself && whole_turns(barrier) == 0;
}

std::string remark_on_closure(const Barrier& barrier) {
  if (!crosses_itself(barrier)) return {};
  return remark_on_boundary(*barrier.tangle) + "; T by boundaries is not known where the path meets the manifolds";
}

Measured enclosed_area(const Barrier& barrier) {
  const Tangle& tangle = *barrier.tangle;
  const SweptArea swept = swept_area(tangle, barrier.bip);
  const std::vector<Point> line = boundary_arcs(tangle, barrier.bip);
  double length = 0;
  for (std::size_t j = 1; j < line.size(); ++j) length += distance(line[j - 1], line[j]);
  const double beside = barrier.error_up_to(barrier.bip) * length, error = swept.error + beside;
  const int turns = turns_of(barrier);
  if (crosses_itself(barrier)) {
    const Boundary& boundary = *tangle.boundary;
    return {boundary.area, std::max(boundary.smooth_error, tangle.rounding(boundary.area)) + beside};
  }
  if (turns == 0) return {std::fabs(swept.area), error};
  // Swept against the chord between both saddles, which runs along the lattice.
  const double below = along_and_above(barrier.lattice, line.front()).y * detail::length(barrier.lattice);
  return {below - turns * swept.area, error};
}

WindingProduct product_of_windings(const std::vector<Point>& first, const std::vector<Point>& second) {
  if (first.empty() || second.empty()) return {};
  const Box both = intersection(box_of(first), box_of(second));
  if (!(both.width() >= 0 && both.height() >= 0)) return {};
  const CommonArea product = winding_product(ClosedCurve::borrow(first), ClosedCurve::borrow(second));
  return {product.area, product.error, length_in(first, both) + length_in(second, both)};
}

}  // namespace lober::detail
