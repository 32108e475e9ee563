#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "engine/geometry/curve/cut_outside.hpp"
#include "kernels/box.hpp"
#include "lober/curve/curve.hpp"

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

// Moves points beyond straight to the border; of points there in a row the first and the last are enough.
std::vector<Point> pushed(const std::vector<Point>& path, const HalfPlane& half) {
  std::vector<Point> moved;
  moved.reserve(path.size());
  bool on_border = false;  // the last two points
  const auto add = [&](Point p, bool border) {
    if (border && on_border) moved.pop_back();
    on_border = border && !moved.empty() && half.beyond(moved.back()) == 0;
    moved.push_back(p);
  };
  for (std::size_t k = 0; k < path.size(); ++k) {
    const bool in = half.beyond(path[k]) <= 0;
    if (k > 0 && in != (half.beyond(path[k - 1]) <= 0)) add(half.on_side(path[k - 1], path[k]), true);
    Point p = path[k];
    if (!in) (half.of_x ? p.x : p.y) = half.sign * half.bound;
    add(p, !in);
  }
  return moved;
}

std::array<HalfPlane, 4> sides_of(const Rectangle& rectangle) {
  return {{{true, 1, rectangle.max_x},
           {true, -1, -rectangle.min_x},
           {false, 1, rectangle.max_y},
           {false, -1, -rectangle.min_y}}};
}

}  // namespace

std::vector<Point> clipped(const std::vector<Point>& polygon, const Rectangle& rectangle) {
  std::vector<Point> rest;
  const std::vector<Point>* left = &polygon;
  for (const HalfPlane& side : sides_of(rectangle)) {
    if (side.holds(*left)) continue;  // often
    rest = cut(*left, side);
    left = &rest;
  }
  return left == &polygon ? polygon : rest;
}

std::vector<Point> detail::cut_outside(std::span<const Point> polygon, const Rectangle& rectangle, std::size_t beside) {
  const std::size_t size = polygon.size();
  const Box inside = box_of(rectangle);
  std::vector<bool> kept(size);
  // Keeps each vertex of a run of segments that meet the rectangle, and `beside` more before and after.
  std::size_t until = 0;  // exclusive, as if the polygon went on
  for (std::size_t k = 0; k < size; ++k) {
    if (!meet(Box::of(polygon[k], polygon[k + 1 == size ? 0 : k + 1]), inside)) continue;
    for (std::size_t j = std::max(k + size - beside, until); j < k + size + 2 + beside; ++j) kept[j % size] = true;
    until = k + size + 2 + beside;
  }
  const auto first = static_cast<std::size_t>(std::find(kept.begin(), kept.end(), true) - kept.begin());
  if (first == size) return clipped({polygon.begin(), polygon.end()}, rectangle);
  std::vector<Point> result;
  for (std::size_t k = first; k < first + size;) {
    result.push_back(polygon[k % size]);
    std::size_t next = k + 1;
    while (!kept[next % size]) ++next;
    if (next > k + 1) {
      std::vector<Point> path;
      for (std::size_t j = k; j <= next; ++j) path.push_back(polygon[j % size]);
      for (const HalfPlane& side : sides_of(rectangle)) path = pushed(path, side);
      result.insert(result.end(), path.begin(), path.end());
    }
    k = next;
  }
  return result;
}

}  // namespace lober
