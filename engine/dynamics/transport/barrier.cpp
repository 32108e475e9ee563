#include "engine/dynamics/transport/barrier.hpp"

#include <algorithm>
#include <cmath>

#include "kernels/box.hpp"
#include "kernels/sagitta.hpp"
#include "lober/curve.hpp"
#include "lober/error.hpp"
#include "lober/overlay.hpp"
#include "lober/regions.hpp"
#include "lober/smooth.hpp"

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

// A closed polygon cut off at a box (Sutherland & Hodgman 1974): inside the box winding numbers stay what they are.
std::vector<Point> clipped(std::vector<Point> polygon, const Box& box) {
  for (std::size_t side = 0; side < 4; ++side) {
    // How far inside the half-plane of this side.
    const auto depth = [&](Point p) {
      const double along = side % 2 == 0 ? p.x : p.y;
      return side < 2 ? along - box.lane[side] : -along - box.lane[side];
    };
    std::vector<Point> inside;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Point a = polygon[k], b = polygon[k + 1 == polygon.size() ? 0 : k + 1];
      const double from = depth(a), to = depth(b);
      if (from >= 0) inside.push_back(a);
      if ((from >= 0) != (to >= 0)) {
        const double t = from / (from - to);
        inside.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
      }
    }
    polygon = std::move(inside);
  }
  return polygon;
}

// Area between the segments of a closed polygon that meet a box and smooth curves through its vertices, by estimate.
double chord_area(const std::vector<Point>& polygon, const Box& box) {
  double sum = 0;
  const std::size_t size = polygon.size();
  for (std::size_t k = 0; k < size; ++k) {
    const Point a = polygon[k], b = polygon[(k + 1) % size];
    if (!meet(Box::of(a, b), box)) continue;
    sum += std::fabs(twice_chord_area(polygon[(k + size - 1) % size], a, b, polygon[(k + 2) % size])) / 2;
  }
  return sum;
}

// Simple polygons as smooth curves. Where manifolds are followed coarsely, far out, their polygons may cross
// themselves; then the integral of the product of the winding numbers, of the polygons, where both boxes meet.
Measured by_overlay(const std::vector<Point>& first, const std::vector<Point>& second, const Box& both) {
  try {
    OverlayOptions options;
    options.pieces = false;
    const SmoothAreas smooth = smooth_areas(overlay(ClosedCurve::borrow(first), ClosedCurve::borrow(second), options));
    return {smooth.areas.intersection, smooth.error.intersection};
  } catch (const NotSimpleError&) {
    const std::vector<Point> one = clipped(first, both), other = clipped(second, both);
    if (one.size() < 3 || other.size() < 3) return {};
    const Regions found = regions(ClosedCurve::borrow(one), ClosedCurve::borrow(other));
    double sum = 0;
    for (const WindingArea& entry : found.table()) sum += entry.w1 * entry.w2 * entry.area;
    return {std::fabs(sum), chord_area(first, both) + chord_area(second, both) + found.rounding(std::fabs(sum))};
  }
}

}  // namespace

std::vector<Point> outline_of(const Barrier& barrier, int k) {
  const std::size_t pip = barrier.pip(k);
  std::vector<Point> points = boundary_arcs(*barrier.tangle, pip);
  // The corner is where the smooth curves cross, if they do, not where their polygons do.
  const Point corner = barrier.tangle->nodes[barrier.tangle->pips[pip].node].begin;
  const auto at = std::find(points.begin() + barrier.tangle->pips[pip].u.segment, points.end(), corner);
  if (at != points.end()) *at = barrier.tangle->pips[pip].at;
  points.insert(points.end(), barrier.tangle->closure.begin(), barrier.tangle->closure.end());
  return points;
}

bool closure_is_crossed(const Barrier& barrier, int k) {
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

Measured enclosed_area(const Barrier& barrier, int k) {
  const Tangle& tangle = *barrier.tangle;
  const SweptArea swept = swept_area(tangle, barrier.pip(k));
  const std::vector<Point> line = boundary_arcs(tangle, barrier.pip(k));
  double length = 0;
  for (std::size_t j = 1; j < line.size(); ++j) length += distance(line[j - 1], line[j]);
  return {std::fabs(swept.area), swept.error + barrier.curve_error * length};
}

Measured area_in_common(const std::vector<Point>& first, const std::vector<Point>& second, double curve_error) {
  const Box both = intersection(box_of(first), box_of(second));
  if (!(both.width() >= 0 && both.height() >= 0)) return {};
  Measured common = by_overlay(first, second, both);
  common.error += curve_error * (length_in(first, both) + length_in(second, both));
  return common;
}

}  // namespace lober::detail
