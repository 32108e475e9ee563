#include "engine/overlay/boundary.hpp"

#include <algorithm>

#include "engine/overlay/faces.hpp"

namespace lober {
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

Directions directions(const Overlay& result, Pairing pairing) {
  const bool left1 = pairing != Pairing::c2_minus_c1, left2 = pairing != Pairing::c1_minus_c2;
  return {left1 != result.nodes.clockwise1(), left2 != result.nodes.clockwise2()};
}

std::vector<Stretch> stretches(const Overlay& result, std::span<const std::uint32_t> steps, bool forward1,
                               bool forward2) {
  const NodeGraph& graph = result.nodes.graph();
  std::vector<Stretch> list;
  if (steps.size() == 1 && steps[0] >= Pieces::whole1) {
    const bool first = steps[0] == Pieces::whole1;
    list.push_back({first ? 1 : 2, first ? forward1 : forward2, Stretch::none, Stretch::none});
    return list;
  }
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const Step step = unpack(steps[k]), before = unpack(steps[k == 0 ? steps.size() - 1 : k - 1]);
    const Step after = unpack(steps[k + 1 == steps.size() ? 0 : k + 1]);
    const NodeSpan span = graph.span(step.node);
    const auto forward = [&](std::uint32_t curve) { return curve == 0 ? forward1 : forward2; };
    const int curve = step.curve == 0 ? 1 : 2, curve_before = before.curve == 0 ? 1 : 2;
    const std::uint32_t arrived = ends_of(span, curve_before, forward(before.curve)).enters;
    const std::uint32_t leaves = ends_of(span, curve, forward(step.curve)).leaves;
    if (arrived != leaves) list.push_back({1, arrived == span.first, arrived, leaves});
    const std::uint32_t enters = ends_of(graph.span(after.node), curve, forward(step.curve)).enters;
    list.push_back({curve, forward(step.curve), leaves, enters});
  }
  return list;
}

void append_points(const Overlay& result, const Stretch& stretch, std::vector<Point>& points) {
  const CurveView& curve = stretch.curve == 1 ? result.nodes.curve1() : result.nodes.curve2();
  const auto size = static_cast<std::uint32_t>(curve.points.size());
  if (stretch.from == Stretch::none) {
    points.insert(points.end(), curve.points.begin(), curve.points.end());
    if (!stretch.forward) std::reverse(points.end() - static_cast<std::ptrdiff_t>(size), points.end());
    return;
  }
  const ContactList& contacts = result.nodes.graph().contacts;
  const Contact from = contacts[stretch.from], to = contacts[stretch.to];
  const auto segment_of = [&](const Contact& c) { return stretch.curve == 1 ? c.segment1 : c.segment2; };
  const auto at_vertex = [&](const Contact& c) { return stretch.curve == 1 ? c.vertex1 : c.vertex2; };
  const auto parameter = [&](const Contact& c) { return stretch.curve == 1 ? c.t1 : c.t2; };
  points.push_back(result.nodes.place(from));

  // Vertices strictly between: from `first` on, `count` of them.
  const std::uint32_t begin = segment_of(stretch.forward ? from : to), end = segment_of(stretch.forward ? to : from);
  const Contact &low = stretch.forward ? from : to, &high = stretch.forward ? to : from;
  const bool same_segment = begin == end;
  const DD gap = parameter(high) - parameter(low);
  const bool wraps = end < begin || (same_segment && (stretch.from == stretch.to || gap.hi < 0));
  std::uint32_t count = wraps ? size - begin + end : end - begin;
  if (at_vertex(high) && count > 0) --count;
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::uint32_t place = stretch.forward ? k : count - 1 - k;
    points.push_back(curve.points[(begin + 1 + place) % size]);
  }
}

std::vector<std::vector<Point>> outline(const Overlay& result, Pairing pairing, std::size_t piece) {
  const Pieces& pieces = result.pieces(pairing);
  const Directions forward = directions(result, pairing);
  const auto polygon = [&](std::span<const std::uint32_t> steps) {
    std::vector<Point> points;
    for (const Stretch& stretch : stretches(result, steps, forward.forward1, forward.forward2))
      append_points(result, stretch, points);
    return points;
  };
  std::vector<std::vector<Point>> polygons{polygon(pieces.outer(piece))};
  for (const Pieces::Hole& hole : pieces.holes_of(piece)) polygons.push_back(polygon(hole.steps));
  return polygons;
}

}  // namespace lober
