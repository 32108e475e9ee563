// Centroid, perimeter and discretisation error of the lobes, arc by arc.

#include <algorithm>
#include <cmath>

#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/tangle/curves.hpp"
#include "kernels/sagitta.hpp"

namespace lober {
using namespace detail;
namespace {

// The chord area of the part of segment k between two positions. Its neighbours are the nearest vertices at other
// points; an end of the curve has none.
double chord_area_of(const CurveView& curve, std::size_t k, Position from, Position to) {
  const std::span<const Point> p = curve.points;
  if (p[k] == p[k + 1]) return 0;
  std::size_t back = k, forth = k + 1;
  while (back > 0 && p[back] == p[k]) --back;
  while (forth + 1 < p.size() && p[forth] == p[k + 1]) ++forth;
  const double begin = k == from.segment ? sagitta_fraction(from.t) : 0;
  const double end = k == to.segment ? sagitta_fraction(to.t) : 1;
  return twice_chord_area(p[back], p[k], p[k + 1], p[forth]) * (end - begin);
}

void add_segment(ArcMeasures& sums, Point a, Point b, Point origin) {
  const double ax = a.x - origin.x, ay = a.y - origin.y, dx = b.x - a.x, dy = b.y - a.y;
  const double term = ax * dy - ay * dx;
  sums.twice_area += term;
  sums.moment_x += term * (2 * ax + dx);
  sums.moment_y += term * (2 * ay + dy);
  sums.length += std::sqrt(dx * dx + dy * dy);
}

// The arc of a curve between two positions with these points: the first and the last segment by themselves, those at
// the ends of the curve, which have no neighbours, and all where a repeated vertex has neighbours farther away.
void add_arc(ArcMeasures& sums, const CurveView& curve, Position from, Point first, Position to, Point last,
             Point origin) {
  const std::span<const Point> p = curve.points;
  const std::size_t begin = std::max<std::size_t>(from.segment + std::size_t{1}, 1);
  const std::size_t end = std::min<std::size_t>(to.segment, p.size() < 2 ? 0 : p.size() - 2);
  if (from.segment == to.segment) {
    add_segment(sums, first, last, origin);
    sums.chord_area += std::fabs(chord_area_of(curve, from.segment, from, to));
    return;
  }
  add_segment(sums, first, p[from.segment + 1], origin);
  sums.chord_area += std::fabs(chord_area_of(curve, from.segment, from, to));
  std::size_t next = begin;
  if (begin < end) {
    const std::span<const Point> inner = p.subspan(begin - 1, end - begin + 3);
    if (std::adjacent_find(inner.begin(), inner.end()) == inner.end()) {
      add_arc_measures(inner.data(), end - begin, origin, sums);
      next = end;
    }
  }
  for (std::size_t k = next; k < to.segment; ++k) {
    add_segment(sums, p[k], p[k + 1], origin);
    sums.chord_area += std::fabs(chord_area_of(curve, k, from, to));
  }
  add_segment(sums, p[to.segment], last, origin);
  sums.chord_area += std::fabs(chord_area_of(curve, to.segment, from, to));
}

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
    // About the first pip: edges in all products instead of far corners.
    ArcMeasures measures;
    add_arc(measures, u, first.u, begin, last.u, end, begin);
    add_arc(measures, s, last.s, end, first.s, begin, begin);
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
  ArcMeasures measures;
  const auto add = [&](const CurveView& curve, Position to) {
    add_arc(measures, curve, {}, curve.points[0], to, curve.points[to.segment], curve.points[0]);
  };
  add(curves.u().view(), bip.u);
  add(curves.s().view(), bip.s);
  return curves.area({measures.chord_area, 0});
}

}  // namespace lober
