#include "engine/transport/barrier.hpp"

#include <algorithm>
#include <cmath>

#include "engine/curve/curve.hpp"
#include "engine/smooth/smooth.hpp"
#include "kernels/box.hpp"

namespace lober {
namespace {

// The path that closes the boundary, from p+ to p-.
std::vector<Point> closing_path(const Barrier& barrier) {
  std::vector<Point> path{barrier.tangle->s().points[0]};
  path.insert(path.end(), barrier.closure.begin(), barrier.closure.end());
  path.push_back(barrier.tangle->u().points[0]);
  return path;
}

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

}  // namespace

std::vector<Point> outline_of(const Barrier& barrier, int k) {
  std::vector<Point> points = boundary_outline(*barrier.tangle, barrier.pip(k));
  points.insert(points.end(), barrier.closure.begin(), barrier.closure.end());
  return points;
}

bool closure_is_crossed(const Barrier& barrier, int k) {
  const std::vector<Point> path = closing_path(barrier);
  if (path.size() == 2 && path[0] == path[1]) return false;
  const std::vector<Point> line = boundary_outline(*barrier.tangle, barrier.pip(k));
  const Point start = path.back(), end = path.front();
  const IndexedCurve closing({path, false}), manifolds({line, false});
  const ContactList contacts = find_contacts(closing, manifolds, IndexKind::tree).list;
  for (std::size_t j = 0; j < contacts.size(); ++j) {
    const Contact contact = contacts[j];
    const Point at = line[contact.segment2];
    if (!(contact.vertex1 && contact.vertex2 && (at == start || at == end))) return true;
  }
  return false;
}

Measured enclosed_area(const Barrier& barrier, int k) {
  const Tangle& tangle = *barrier.tangle;
  const SweptArea swept = swept_area(tangle, barrier.pip(k));
  // The path in place of the chord.
  const std::vector<Point> path = closing_path(barrier);
  double twice = 0;
  for (std::size_t j = 1; j + 1 < path.size(); ++j) {
    const Point o = path[0], a = path[j], b = path[j + 1];
    twice += (a.x - o.x) * (b.y - o.y) - (b.x - o.x) * (a.y - o.y);
  }
  const std::vector<Point> line = boundary_outline(tangle, barrier.pip(k));
  double length = 0;
  for (std::size_t j = 1; j < line.size(); ++j) length += distance(line[j - 1], line[j]);
  return {std::fabs(swept.area + twice / 2), swept.error + barrier.curve_error * length};
}

Measured area_in_common(const std::vector<Point>& first, const std::vector<Point>& second, double curve_error) {
  const Box both = intersection(box_of(first), box_of(second));
  const CommonArea common = common_area(CurveView{first}, CurveView{second});
  return {common.area, common.error + curve_error * (length_in(first, both) + length_in(second, both))};
}

}  // namespace lober
