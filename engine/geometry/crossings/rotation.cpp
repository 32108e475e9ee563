#include "engine/geometry/crossings/rotation.hpp"

#include <algorithm>
#include <array>

namespace lober::detail {

using enum HalfEdge;
namespace {

// Points further along a curve, onwards and back, from a contact on segment `number`.
struct Ways {
  Point onwards, back;
};
Ways ways(const CurveView& curve, std::uint32_t number, bool at_vertex) {
  const auto [a, b] = curve.segment(number);
  if (!at_vertex) return {b, a};
  return {curve.points[next_distinct(curve, number, 1)], curve.points[next_distinct(curve, number, -1)]};
}

// Whether two half-edges lead the same way, or one of them does not exist.
bool no_angle(Point at, Point x, Point y, PredicateCounts& counts) {
  const auto sign = [](double value) { return (value > 0) - (value < 0); };
  if (x == at || y == at) return true;
  return sign(x.x - at.x) == sign(y.x - at.x) && sign(x.y - at.y) == sign(y.y - at.y) &&
         orient2d(at, x, y, counts) == 0;
}

std::uint8_t number_of(const std::array<HalfEdge, 4>& half_edges) {
  return static_cast<std::uint8_t>(std::find(rotations.begin(), rotations.end(), half_edges) - rotations.begin());
}

}  // namespace

std::uint32_t next_distinct(const CurveView& curve, std::uint32_t vertex, int direction) {
  const auto size = static_cast<std::uint32_t>(curve.points.size());
  std::uint32_t next = vertex;
  do {
    if (!curve.closed && next == (direction > 0 ? size - 1 : 0)) return vertex;
    next = direction > 0 ? (next + 1 == size ? 0 : next + 1) : (next == 0 ? size - 1 : next - 1);
  } while (curve.points[next] == curve.points[vertex] && next != vertex);
  return next;
}

NodeHalfEdges half_edges_of(const Contact& contact, const CurveView& c1, const CurveView& c2) {
  NodeHalfEdges half_edges;
  half_edges.at = contact.vertex1 ? c1.points[contact.segment1] : c2.points[contact.segment2];
  const Ways first = ways(c1, contact.segment1, contact.vertex1);
  const Ways second = ways(c2, contact.segment2, contact.vertex2);
  half_edges.target[index_of(forward1)] = first.onwards;
  half_edges.target[index_of(backward1)] = first.back;
  half_edges.target[index_of(forward2)] = second.onwards;
  half_edges.target[index_of(backward2)] = second.back;
  return half_edges;
}

bool turns_first(Point at, Point from, Point x, Point y, PredicateCounts& counts) {
  // 0: less than a half turn away, 1: more, or exactly (nothing else can be opposite at the same time).
  const auto half = [&](Point p) { return orient2d(at, from, p, counts) > 0 ? 0 : 1; };
  const int half_x = half(x), half_y = half(y);
  if (half_x != half_y) return half_x < half_y;
  return orient2d(at, x, y, counts) > 0;
}

std::uint8_t rotation_at_point(const Contact& contact, const CurveView& c1, const CurveView& c2,
                               PredicateCounts& counts) {
  if (contact.proper()) return contact.rho > 0 ? rightward_to_left : leftward_to_right;
  const NodeHalfEdges half_edges = half_edges_of(contact, c1, c2);
  for (const HalfEdge own : {forward1, backward1}) {
    for (const HalfEdge other : {forward2, backward2}) {
      if (no_angle(half_edges.at, half_edges.target[index_of(own)], half_edges.target[index_of(other)], counts))
        return first_touch;
    }
  }
  std::array<HalfEdge, 4> order{forward1, forward2, backward1, backward2};
  std::sort(order.begin() + 1, order.end(), [&](HalfEdge x, HalfEdge y) {
    return x != y && turns_first(half_edges.at, half_edges.target[index_of(forward1)], half_edges.target[index_of(x)],
                                 half_edges.target[index_of(y)], counts);
  });
  return number_of(order);
}

std::uint8_t rotation_at_arc(const Contact& first, const Contact& last, int direction, const CurveView& c1,
                             const CurveView& c2, PredicateCounts& counts) {
  const HalfEdge at_first = direction > 0 ? backward2 : forward2, at_last = direction > 0 ? forward2 : backward2;
  const NodeHalfEdges begin = half_edges_of(first, c1, c2), end = half_edges_of(last, c1, c2);
  if (no_angle(begin.at, begin.target[index_of(backward1)], begin.target[index_of(at_first)], counts) ||
      no_angle(end.at, end.target[index_of(forward1)], end.target[index_of(at_last)], counts)) {
    return first_touch;
  }
  const bool first_left = turns_first(begin.at, begin.target[index_of(forward1)], begin.target[index_of(at_first)],
                                      begin.target[index_of(backward1)], counts);
  const bool last_left = turns_first(end.at, end.target[index_of(forward1)], end.target[index_of(at_last)],
                                     end.target[index_of(backward1)], counts);
  if (first_left && last_left) return number_of({forward1, at_last, at_first, backward1});
  if (!first_left && !last_left) return number_of({forward1, backward1, at_first, at_last});
  return first_left == (direction > 0) ? leftward_to_right : rightward_to_left;
}

}  // namespace lober::detail
