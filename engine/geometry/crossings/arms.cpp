#include "engine/geometry/crossings/arms.hpp"

#include <algorithm>
#include <array>

namespace lober {
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

// Whether two arms lead the same way, or one of them does not exist.
bool no_angle(Point at, Point x, Point y, PredicateCounts& counts) {
  const auto sign = [](double value) { return (value > 0) - (value < 0); };
  if (x == at || y == at) return true;
  return sign(x.x - at.x) == sign(y.x - at.x) && sign(x.y - at.y) == sign(y.y - at.y) &&
         orient2d(at, x, y, counts) == 0;
}

std::uint8_t number_of(const std::array<Arm, 4>& arms) {
  return static_cast<std::uint8_t>(std::find(arm_orders.begin(), arm_orders.end(), arms) - arm_orders.begin());
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

Arms arms_of(const Contact& contact, const CurveView& c1, const CurveView& c2) {
  Arms arms;
  arms.at = contact.vertex1 ? c1.points[contact.segment1] : c2.points[contact.segment2];
  const Ways first = ways(c1, contact.segment1, contact.vertex1);
  const Ways second = ways(c2, contact.segment2, contact.vertex2);
  arms.target[out1] = first.onwards;
  arms.target[in1] = first.back;
  arms.target[out2] = second.onwards;
  arms.target[in2] = second.back;
  return arms;
}

bool turns_first(Point at, Point from, Point x, Point y, PredicateCounts& counts) {
  // 0: less than a half turn away, 1: more, or exactly (nothing else can be opposite at the same time).
  const auto half = [&](Point p) { return orient2d(at, from, p, counts) > 0 ? 0 : 1; };
  const int half_x = half(x), half_y = half(y);
  if (half_x != half_y) return half_x < half_y;
  return orient2d(at, x, y, counts) > 0;
}

std::uint8_t arm_order_at_point(const Contact& contact, const CurveView& c1, const CurveView& c2,
                                PredicateCounts& counts) {
  if (contact.proper()) return contact.rho > 0 ? rightward_to_left : leftward_to_right;
  const Arms arms = arms_of(contact, c1, c2);
  for (const Arm own : {out1, in1}) {
    for (const Arm other : {out2, in2}) {
      if (no_angle(arms.at, arms.target[own], arms.target[other], counts)) return first_touch;
    }
  }
  std::array<Arm, 4> order{out1, out2, in1, in2};
  std::sort(order.begin() + 1, order.end(), [&](Arm x, Arm y) {
    return x != y && turns_first(arms.at, arms.target[out1], arms.target[x], arms.target[y], counts);
  });
  return number_of(order);
}

std::uint8_t arm_order_at_arc(const Contact& first, const Contact& last, int direction, const CurveView& c1,
                              const CurveView& c2, PredicateCounts& counts) {
  const Arm at_first = direction > 0 ? in2 : out2, at_last = direction > 0 ? out2 : in2;
  const Arms begin = arms_of(first, c1, c2), end = arms_of(last, c1, c2);
  if (no_angle(begin.at, begin.target[in1], begin.target[at_first], counts) ||
      no_angle(end.at, end.target[out1], end.target[at_last], counts)) {
    return first_touch;
  }
  const bool first_left = turns_first(begin.at, begin.target[out1], begin.target[at_first], begin.target[in1], counts);
  const bool last_left = turns_first(end.at, end.target[out1], end.target[at_last], end.target[in1], counts);
  if (first_left && last_left) return number_of({out1, at_last, at_first, in1});
  if (!first_left && !last_left) return number_of({out1, in1, at_first, at_last});
  return first_left == (direction > 0) ? leftward_to_right : rightward_to_left;
}

}  // namespace lober
