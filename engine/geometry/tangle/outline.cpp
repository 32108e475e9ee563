// Lobes and boundary as polygons.

#include <string>

#include "engine/geometry/tangle/boundary.hpp"
#include "lober/overlay/regions.hpp"

namespace lober {
using namespace detail;
namespace {

// The vertices of a curve strictly between two positions, the first of which comes first.
void append_between(const CurveView& curve, Position from, Position to, std::vector<Point>& points) {
  const auto first = curve.points.begin() + from.segment + 1, last = curve.points.begin() + to.segment + 1;
  points.insert(points.end(), first, last);
}

// The pip as a point of the polygons.
Point point_of_pip(const Tangle& tangle, std::size_t pip) {
  return tangle.nodes[tangle.pips.at(pip).node].begin;
}

void append(std::vector<Point>& points, Point point) {
  if (points.empty() || !(points.back() == point)) points.push_back(point);
}

}  // namespace

double perimeter(const std::vector<Point>& polygon) {
  double length = distance(polygon.back(), polygon.front());
  for (std::size_t k = 1; k < polygon.size(); ++k) length += distance(polygon[k - 1], polygon[k]);
  return length;
}

std::vector<Point> lobe_outline(const Tangle& tangle, std::size_t lobe) {
  const Pip &first = tangle.pips[lobe], &last = tangle.pips[lobe + 1];
  const Point begin = point_of_pip(tangle, lobe);
  std::vector<Point> points{begin};
  append_between(tangle.u(), first.u, last.u, points);
  append(points, point_of_pip(tangle, lobe + 1));
  append_between(tangle.s(), last.s, first.s, points);  // S runs from the later pip to the earlier one
  while (points.size() > 1 && points.back() == begin) points.pop_back();
  return points;
}

std::vector<Point> boundary_outline(const Tangle& tangle) {
  std::vector<Point> points = boundary_arcs(tangle, tangle.boundary->bip);
  points.insert(points.end(), tangle.closure.begin(), tangle.closure.end());
  return points;
}

std::vector<Point> boundary_arcs(const Tangle& tangle, std::size_t number) {
  const Pip& bip = tangle.pips.at(number);
  const auto u = tangle.u().points.first(bip.u.segment + 1);
  const auto s = tangle.s().points.first(bip.s.segment + 1);
  std::vector<Point> points(u.begin(), u.end());
  append(points, point_of_pip(tangle, number));
  for (std::size_t k = s.size(); k-- > 0;) append(points, s[k]);
  return points;
}

std::string remark_on_boundary(const Tangle& tangle) {
  if (!tangle.boundary || !tangle.boundary->crosses_itself) return {};
  return "the boundary crosses itself, because the path that closes it meets the manifolds or itself, and bounds no "
         "region: its area is that of what it winds round, and L12, L21 and fluxes by lobes hold only as far as fluid "
         "does not cross that path; give a path (closure) that keeps away from them";
}

SweptArea swept_area(const Tangle& tangle, std::size_t number) {
  const double area = tangle.curves->area(twice_swept(tangle, number));
  return {area, tangle.curves->area({tangle.pips.at(number).gap_error, 0}) + tangle.rounding(area)};
}

std::vector<double> lobe_pieces(const Tangle& tangle, std::size_t lobe) {
  const std::vector<Point> outline = lobe_outline(tangle, lobe);
  const Regions region = regions(ClosedCurve::borrow(outline));
  const RegionPieces pieces = region.pieces(FillRule::nonzero, Pairing::c1_minus_c2);
  return {pieces.areas().begin(), pieces.areas().end()};
}

}  // namespace lober
