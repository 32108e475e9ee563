// Centroid, perimeter and discretisation error of the lobes, arc by arc.

#include <cmath>

#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/tangle/curves.hpp"
#include "kernels/sagitta.hpp"

namespace lober {
using namespace detail;
namespace {

// Plain doubles: with the first pip for origin and edges instead of far corners in every product, a lobe of length l
// and width w loses about l / w ulps.
struct Measures {
  double twice_area = 0, moment_x = 0, moment_y = 0;  // about the first pip
  double length = 0;
  double chord_area = 0;

  void add_segment(Point a, Point b, Point origin) {
    const double ax = a.x - origin.x, ay = a.y - origin.y, dx = b.x - a.x, dy = b.y - a.y;
    const double term = ax * dy - ay * dx;
    twice_area += term;
    moment_x += term * (2 * ax + dx);
    moment_y += term * (2 * ay + dy);
    length += std::sqrt(dx * dx + dy * dy);
  }

  // The arc of a curve between two positions with these points.
  void add_arc(const CurveView& curve, Position from, Point first, Position to, Point last, Point origin) {
    Point a = first;
    for (std::size_t k = from.segment + std::size_t{1}; k <= to.segment; ++k) {
      add_segment(a, curve.points[k], origin);
      a = curve.points[k];
    }
    add_segment(a, last, origin);
    add_chord_areas(curve, from, to);
  }
  void add_chord_areas(const CurveView& curve, Position from, Position to) {
    for (std::size_t k = from.segment; k <= to.segment; ++k) chord_area += std::fabs(chord_area_of(curve, k, from, to));
  }

  // Of the part of segment k that lies between the two positions.
  static double chord_area_of(const CurveView& curve, std::size_t k, Position from, Position to) {
    const std::span<const Point> p = curve.points;
    const Point before = k > 0 ? p[k - 1] : p[k], after = k + 2 < p.size() ? p[k + 2] : p[k + 1];
    const double begin = k == from.segment ? sagitta_fraction(from.t) : 0;
    const double end = k == to.segment ? sagitta_fraction(to.t) : 1;
    return twice_chord_area(before, p[k], p[k + 1], after) * (end - begin);
  }
};

}  // namespace

std::vector<LobeShape> lobe_shapes(const Tangle& tangle) {
  std::vector<LobeShape> shapes(tangle.lobes.size());
  const TangleCurves& curves = *tangle.curves;  // at a scale where squares stay in range
  const CurveView &u = curves.u().view(), &s = curves.s().view();
  const auto scaled_by = [&](Point p, int exponent) {
    return exponent == 0 ? p : Point{std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
  };
  for_each_block(shapes.size(), 1, [&](std::size_t k, std::size_t) {
    const Pip &first = tangle.pips[k], &last = tangle.pips[k + 1];
    const Point begin = scaled_by(tangle.nodes[first.node].begin, curves.exponent);
    const Point end = scaled_by(tangle.nodes[last.node].begin, curves.exponent);
    Measures measures;
    measures.add_arc(u, first.u, begin, last.u, end, begin);
    measures.add_arc(s, last.s, end, first.s, begin, begin);
    LobeShape& shape = shapes[k];
    const double below = 3 * measures.twice_area;
    const Point centroid =
        below == 0 ? begin : Point{begin.x + measures.moment_x / below, begin.y + measures.moment_y / below};
    shape.centroid = scaled_by(centroid, -curves.exponent);
    shape.perimeter = std::ldexp(measures.length, -curves.exponent);
    shape.width = shape.perimeter > 0 ? 2 * std::fabs(tangle.lobes[k].area) / shape.perimeter : 0;
    shape.discretisation = curves.area({measures.chord_area, 0});
  });
  return shapes;
}

double boundary_discretisation(const Tangle& tangle) {
  const Pip& bip = tangle.pips.at(tangle.boundary->bip);
  const TangleCurves& curves = *tangle.curves;
  Measures measures;
  measures.add_chord_areas(curves.u().view(), {}, bip.u);
  measures.add_chord_areas(curves.s().view(), {}, bip.s);
  return curves.area({measures.chord_area, 0});
}

}  // namespace lober
