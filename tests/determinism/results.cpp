#include "tests/determinism/results.hpp"

#include <algorithm>

#include "engine/geometry/overlay/pieces_data.hpp"
#include "lober/curve/densify.hpp"
#include "lober/overlay/interior.hpp"
#include "lober/overlay/overlay.hpp"
#include "lober/overlay/regions.hpp"
#include "lober/tangle/tangle.hpp"
#include "tests/determinism/hash.hpp"
#include "tests/views.hpp"

namespace lober::detail {
namespace {

void add(Hash& hash, const Areas& areas) {
  for (const double area : {areas.c1, areas.c2, areas.intersection, areas.union_, areas.c1_minus_c2, areas.c2_minus_c1,
                            areas.symmetric_difference}) {
    hash.add(area);
  }
}

void add(Hash& hash, const Position& position) {
  hash.add(position.segment);
  hash.add(position.t);
}

void add(Hash& hash, const Crossings& nodes) {
  hash.add(nodes.size());
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const Node node = nodes[k];
    for (const Position& position : {node.begin1, node.end1, node.begin2, node.end2}) add(hash, position);
    hash.add(node.begin);
    hash.add(node.end);
    hash.add(node.rho);
    hash.add(node.shared);
  }
  hash.add_all(nodes.order2());
}

void add(Hash& hash, const Pieces& pieces) {
  hash.add_all(pieces.areas());
  for (std::size_t k = 0; k < pieces.size(); ++k) hash.add_all(pieces.data().outer(k));
  for (const PieceHole& hole : pieces.data().holes) {
    hash.add(hole.piece);
    hash.add_all(hole.steps);
  }
}

// Some vertices, moved a little, so that they lie on either side of the other curve.
std::vector<Point> probes(CurveView curve, std::size_t count) {
  std::vector<Point> points;
  for (std::size_t k = 0; k < count; ++k) {
    const Point p = curve.points[k * (curve.points.size() / count)];
    points.push_back(k % 2 == 0 ? p : Point{p.x * 0.999 + 1e-4, p.y * 1.001 - 1e-4});
  }
  return points;
}

void add(Hash& hash, const DensifiedCurve& curve) {
  hash.add_all(curve.points);
  for (const Diagnostic& diagnostic : curve.diagnostics) {
    hash.add(diagnostic.first);
    hash.add(diagnostic.count);
  }
}

void add(Hash& hash, const Tangle& found) {
  add(hash, found.nodes);
  for (const Pip& pip : found.pips) {
    hash.add(pip.node);
    hash.add(pip.at);
    add(hash, pip.u);
    add(hash, pip.s);
    hash.add(pip.gap);
    hash.add(pip.gap_low);
    hash.add(pip.gap_error);
  }
  for (const Lobe& lobe : found.lobes) {
    for (const double number : {lobe.area, lobe.polygon_area, lobe.smooth_error, lobe.inside, lobe.outside}) {
      hash.add(number);
    }
    hash.add(lobe.simple);
    hash.add(lobe.meets_closure);
  }
  if (found.boundary) {
    hash.add(found.boundary->bip);
    hash.add(found.boundary->area);
    hash.add(found.boundary->smooth_error);
    hash.add(found.boundary->orientation);
  }
  hash.add(found.images.period);
  hash.add(found.images.area_change);
  hash.add(found.images.turnstile_sum);
  for (const LobeOverlap& both : overlaps(found)) {
    hash.add(both.i);
    hash.add(both.j);
    hash.add(both.area);
  }
  for (const LobeShape& shape : lobe_shapes(found)) {
    hash.add(shape.centroid);
    hash.add(shape.perimeter);
    hash.add(shape.discretisation);
  }
  for (const ArcsAt& arcs : arcs_at_nodes(found)) {
    hash.add(arcs.u);
    hash.add(arcs.s);
  }
}

}  // namespace

std::uint64_t overlay_hash(CurveView c1, CurveView c2, IndexKind index) {
  OverlayOptions options;
  options.index = index;
  const Overlay found = overlay(c1, c2, options);
  Hash hash;
  add(hash, found.areas);
  add(hash, found.rounding);
  add(hash, found.nodes);
  hash.add_all(found.classes);
  for (const Pairing pairing : all_pairings) add(hash, found.pieces(pairing));
  hash.add_all(centroids(found, Pairing::c1_minus_c2));
  const Slivers slivers = find_slivers(found, Pairing::c2_minus_c1);
  hash.add_all(slivers.pieces);
  hash.add(slivers.area);
  add(hash, discretisation_error(found));
  return hash.value();
}

std::uint64_t interior_hash(CurveView c1, CurveView c2, IndexKind index) {
  InteriorOptions options;
  options.index = index;
  const InteriorAreas found = interior_areas(c1, c2, options);
  Hash hash;
  for (const double number : {found.q1, found.q2, found.q3, found.delta}) hash.add(number);
  add(hash, found.areas);
  add(hash, found.rounding);
  add(hash, found.nodes);
  for (const Side side : label_vertices(found.nodes, 1)) hash.add(static_cast<int>(side));
  for (const SideChange& change : side_changes(found.nodes, 2)) {
    add(hash, change.at);
    hash.add(change.point);
    hash.add(static_cast<int>(change.side));
  }
  const IndexedCurve other(c2);
  const std::vector<Point> points = probes(c1, 500);
  for (const Winding& winding : windings(other, points)) {
    hash.add(winding.number);
    hash.add(winding.on);
  }
  for (const InteriorValue& value : interior_function(other, points)) hash.add(value.j);
  return hash.value();
}

std::uint64_t regions_hash(CurveView c1, CurveView c2, IndexKind index) {
  RegionOptions options;
  options.index = index;
  const Regions found = regions(c1, c2, options);
  Hash hash;
  for (const WindingArea& entry : found.table()) {
    hash.add(entry.w1);
    hash.add(entry.w2);
    hash.add(entry.area);
  }
  for (const FillRule rule : all_fill_rules) {
    add(hash, found.areas(rule));
    add(hash, found.rounding(rule));
  }
  for (const Pairing pairing : all_pairings) {
    const RegionPieces pieces = found.pieces(FillRule::nonzero, pairing);
    hash.add_all(pieces.areas());
    for (std::size_t k = 0; k < pieces.size(); ++k) hash.add(pieces[k].holes);
    for (std::size_t k = 0; k < std::min<std::size_t>(pieces.size(), 3); ++k) {
      for (const std::vector<Point>& polygon : pieces.outline(k)) hash.add_all(polygon);
    }
  }
  return hash.value();
}

std::uint64_t tangle_hash(CurveView u, CurveView s, IndexKind index) {
  Hash hash;
  for (const bool smooth : {false, true}) {
    TangleOptions options;
    options.index = index;
    options.smooth = smooth;
    add(hash, tangle(u, s, options));
  }
  return hash.value();
}

std::uint64_t densify_hash(CurveView c1, CurveView c2) {
  Hash hash;
  Criteria criteria = hobson_criteria(c1);
  criteria.max_length = criteria.distance_angle / 3;
  for (const Interpolation interpolation : {Interpolation::dritschel, Interpolation::spline}) {
    DensifyOptions options;
    options.interpolation = interpolation;
    add(hash, densify(c1, criteria, options));
  }
  NearOptions near;
  near.passes = 2;
  add(hash, densify_near(c1, c2, near));
  for (const DensifiedCurve& curve : insert_crossings(c1, c2)) add(hash, curve);
  SimplifyOptions coarser;
  coarser.tolerance = criteria.distance_angle / 10;
  add(hash, simplify(c1, coarser));
  return hash.value();
}

}  // namespace lober::detail
