// Centroid, perimeter and discretisation error of the lobes, arc by arc.

#include <cmath>

#include "engine/parallel/parallel.hpp"
#include "engine/tangle/tangle.hpp"
#include "kernels/sagitta.hpp"
#include "kernels/shoelace.hpp"

namespace lober {
namespace {

struct Measures {
  DD twice_area, moment_x, moment_y;  // about the first pip
  double length = 0;
  double bulge = 0;

  void add_segment(Point a, Point b, Point origin) {
    const DD ax = two_diff(a.x, origin.x), ay = two_diff(a.y, origin.y);
    const DD bx = two_diff(b.x, origin.x), by = two_diff(b.y, origin.y);
    const DD term = cross(ax, ay, bx, by);
    twice_area += term;
    moment_x += term * (ax + bx);
    moment_y += term * (ay + by);
    length += std::hypot(b.x - a.x, b.y - a.y);
  }

  // The arc of a curve between two places with these points.
  void add_arc(const CurveView& curve, Position from, Point first, Position to, Point last, Point origin) {
    Point a = first;
    for (std::size_t k = from.segment + std::size_t{1}; k <= to.segment; ++k) {
      add_segment(a, curve.points[k], origin);
      a = curve.points[k];
    }
    add_segment(a, last, origin);
    for (std::size_t k = from.segment; k <= to.segment; ++k) bulge += std::fabs(bulge_of(curve, k, from, to));
  }

  // Of the part of segment k that lies between the two places.
  static double bulge_of(const CurveView& curve, std::size_t k, Position from, Position to) {
    const std::span<const Point> p = curve.points;
    const Point before = k > 0 ? p[k - 1] : p[k], after = k + 2 < p.size() ? p[k + 2] : p[k + 1];
    const double begin = k == from.segment ? sagitta_fraction(from.t) : 0;
    const double end = k == to.segment ? sagitta_fraction(to.t) : 1;
    return twice_sagitta_area(before, p[k], p[k + 1], after) * (end - begin);
  }
};

}  // namespace

std::vector<LobeShape> lobe_shapes(const Tangle& tangle) {
  std::vector<LobeShape> shapes(tangle.lobes.size());
  for_each_block(shapes.size(), 1, [&](std::size_t k, std::size_t) {
    const Pip &first = tangle.pips[k], &last = tangle.pips[k + 1];
    const Point origin = first.at;
    Measures measures;
    measures.add_arc(tangle.u(), first.u, first.at, last.u, last.at, origin);
    measures.add_arc(tangle.s(), last.s, last.at, first.s, first.at, origin);
    LobeShape& shape = shapes[k];
    const DD below = DD{3, 0} * measures.twice_area;
    shape.centroid = below.hi == 0
                         ? origin
                         : Point{origin.x + (measures.moment_x / below).hi, origin.y + (measures.moment_y / below).hi};
    shape.perimeter = measures.length;
    shape.width = measures.length > 0 ? 2 * std::fabs(tangle.lobes[k].area) / measures.length : 0;
    shape.discretisation = measures.bulge / 2;
  });
  return shapes;
}

}  // namespace lober
