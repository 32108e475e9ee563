#include "engine/geometry/overlay/boundary.hpp"

#include <algorithm>

#include "engine/geometry/crossings/crossings_data.hpp"
#include "engine/geometry/overlay/faces.hpp"
#include "engine/geometry/overlay/pieces_data.hpp"

namespace lober {
using namespace detail;
namespace {

// The contacts at which a walk along one curve leaves a node and enters the next.
struct Ends {
  std::uint32_t leaves, enters;
};
Ends ends_of(const NodeSpan& span, int curve, bool forward) {
  const bool first_to_last = (curve == 1 || span.direction >= 0) == forward;
  return first_to_last ? Ends{span.last, span.first} : Ends{span.first, span.last};
}

}  // namespace

Directions detail::directions(const Overlay& result, Pairing pairing) {
  const bool left1 = pairing != Pairing::c2_minus_c1, left2 = pairing != Pairing::c1_minus_c2;
  return {left1 != result.nodes.clockwise1(), left2 != result.nodes.clockwise2()};
}

std::vector<BoundaryArc> detail::boundary_arcs(const Overlay& result, std::span<const std::uint32_t> steps,
                                               std::size_t begin, std::size_t end, Directions forward) {
  const NodeGraph& graph = graph_of(result.nodes);
  std::vector<BoundaryArc> list;
  if (steps.size() == 1 && steps[0] >= whole_curve1) {
    const bool first = steps[0] == whole_curve1;
    list.push_back({first ? 1 : 2, first ? forward.forward1 : forward.forward2, BoundaryArc::none, BoundaryArc::none});
    return list;
  }
  for (std::size_t k = begin; k < end; ++k) {
    const Step step = unpack(steps[k]), before = unpack(steps[k == 0 ? steps.size() - 1 : k - 1]);
    const Step after = unpack(steps[k + 1 == steps.size() ? 0 : k + 1]);
    const NodeSpan span = graph.span(step.node);
    const auto runs_forward = [&](std::uint32_t curve) { return curve == 0 ? forward.forward1 : forward.forward2; };
    const int curve = step.curve == 0 ? 1 : 2, curve_before = before.curve == 0 ? 1 : 2;
    const std::uint32_t arrived = ends_of(span, curve_before, runs_forward(before.curve)).enters;
    const std::uint32_t leaves = ends_of(span, curve, runs_forward(step.curve)).leaves;
    if (arrived != leaves) list.push_back({1, arrived == span.first, arrived, leaves});
    const std::uint32_t enters = ends_of(graph.span(after.node), curve, runs_forward(step.curve)).enters;
    list.push_back({curve, runs_forward(step.curve), leaves, enters});
  }
  return list;
}

ArcPoints detail::points_of(const Overlay& result, const BoundaryArc& arc) {
  const std::span<const Point> vertices = (arc.curve == 1 ? result.nodes.curve1() : result.nodes.curve2()).points;
  const std::size_t size = vertices.size();
  if (arc.from == BoundaryArc::none) return {arc.forward, true, {}, vertices, {}};
  const ContactList& contacts = graph_of(result.nodes).contacts;
  const Contact from = contacts[arc.from], to = contacts[arc.to];
  const auto segment_of = [&](const Contact& c) { return arc.curve == 1 ? c.segment1 : c.segment2; };
  const auto at_vertex = [&](const Contact& c) { return arc.curve == 1 ? c.vertex1 : c.vertex2; };
  const auto parameter = [&](const Contact& c) { return arc.curve == 1 ? c.t1 : c.t2; };

  // Vertices strictly between, `count` of them.
  const std::size_t begin = segment_of(arc.forward ? from : to), end = segment_of(arc.forward ? to : from);
  const Contact &low = arc.forward ? from : to, &high = arc.forward ? to : from;
  const bool same_segment = begin == end;
  const DD gap = parameter(high) - parameter(low);
  const bool wraps = end < begin || (same_segment && (arc.from == arc.to || gap.hi < 0));
  std::size_t count = wraps ? size - begin + end : end - begin;
  if (at_vertex(high) && count > 0) --count;
  const std::size_t first = begin + 1 == size ? 0 : begin + 1, before_wrap = std::min(count, size - first);
  return {arc.forward, false, contact_point(result.nodes, from), vertices.subspan(first, before_wrap),
          vertices.first(count - before_wrap)};
}

std::size_t detail::count_points(const Overlay& result, std::span<const std::uint32_t> steps, Directions forward) {
  std::size_t count = 0;
  constexpr std::size_t at_once = 256;
  for (std::size_t k = 0; k < steps.size(); k += at_once) {
    for (const BoundaryArc& arc : boundary_arcs(result, steps, k, std::min(k + at_once, steps.size()), forward)) {
      count += points_of(result, arc).size();
    }
  }
  return count;
}

std::vector<std::vector<Point>> outline(const Overlay& result, Pairing pairing, std::size_t piece) {
  const PiecesData& pieces = result.pieces(pairing).data();
  const Directions forward = directions(result, pairing);
  const auto polygon = [&](std::span<const std::uint32_t> steps) {
    std::vector<Point> points;
    for (const BoundaryArc& arc : boundary_arcs(result, steps, 0, steps.size(), forward)) {
      const ArcPoints part = points_of(result, arc);
      if (!part.whole) points.push_back(part.first);
      if (part.forward) {
        points.insert(points.end(), part.low.begin(), part.low.end());
        points.insert(points.end(), part.high.begin(), part.high.end());
      } else {
        points.insert(points.end(), part.high.rbegin(), part.high.rend());
        points.insert(points.end(), part.low.rbegin(), part.low.rend());
      }
    }
    return points;
  };
  std::vector<std::vector<Point>> polygons{polygon(pieces.outer(piece))};
  for (const PieceHole& hole : pieces.holes_of(piece)) polygons.push_back(polygon(hole.steps));
  return polygons;
}

}  // namespace lober
