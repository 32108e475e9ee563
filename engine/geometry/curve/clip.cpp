#include <algorithm>
#include <array>

#include "lober/curve.hpp"

namespace lober {
using namespace detail;
namespace {

// The half-plane sign * coordinate <= bound.
struct HalfPlane {
  bool of_x;
  double sign, bound;
  [[nodiscard]] bool holds(const std::vector<Point>& polygon) const {
    return std::all_of(polygon.begin(), polygon.end(), [&](Point p) { return beyond(p) <= 0; });
  }
  [[nodiscard]] double beyond(Point p) const { return sign * (of_x ? p.x : p.y) - bound; }
  [[nodiscard]] Point on_side(Point a, Point b) const {
    const double from = beyond(a), to = beyond(b), t = from / (from - to);
    Point p{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
    (of_x ? p.x : p.y) = sign * bound;
    return p;
  }
};

std::vector<Point> cut(const std::vector<Point>& polygon, const HalfPlane& half) {
  std::vector<Point> kept;
  kept.reserve(polygon.size());
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point a = polygon[k], b = polygon[k + 1 == polygon.size() ? 0 : k + 1];
    const bool a_in = half.beyond(a) <= 0, b_in = half.beyond(b) <= 0;
    if (a_in) kept.push_back(a);
    if (a_in != b_in) kept.push_back(half.on_side(a, b));
  }
  return kept;
}

}  // namespace

std::vector<Point> clipped(const std::vector<Point>& polygon, const Rectangle& rectangle) {
  const std::array<HalfPlane, 4> sides{{{true, 1, rectangle.max_x},
                                        {true, -1, -rectangle.min_x},
                                        {false, 1, rectangle.max_y},
                                        {false, -1, -rectangle.min_y}}};
  std::vector<Point> rest;
  const std::vector<Point>* left = &polygon;
  for (const HalfPlane& side : sides) {
    if (side.holds(*left)) continue;  // often
    rest = cut(*left, side);
    left = &rest;
  }
  return left == &polygon ? polygon : rest;
}

}  // namespace lober
