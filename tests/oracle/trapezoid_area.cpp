#include "tests/oracle/trapezoid_area.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace lober::oracle {
namespace {

struct Edge {
  double left, right;    // as doubles: only compared
  Rational x, y, slope;  // y + slope (at - x)
  int sign;              // +1: the polygon, taken counter-clockwise, has it as an upper boundary
  [[nodiscard]] Rational at(const Rational& abscissa) const { return y + slope * (abscissa - x); }
};

std::vector<Edge> edges_of(std::span<const Point> points) {
  const int orientation = sgn(trapezoid_area(points));
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& a = points[i];
    const Point& b = points[(i + 1) % points.size()];
    if (a.x == b.x) continue;
    const Rational slope = (Rational(b.y) - Rational(a.y)) / (Rational(b.x) - Rational(a.x));
    edges.push_back({std::min(a.x, b.x), std::max(a.x, b.x), a.x, a.y, slope, a.x > b.x ? orientation : -orientation});
  }
  return edges;
}

// The integral of min(f, g) - floor over the abscissae that both edges have.
Rational common_area(const Edge& f, const Edge& g, const Rational& floor) {
  const Rational from = std::max(f.left, g.left);
  const Rational to = std::min(f.right, g.right);
  const Rational f0 = f.at(from) - floor;
  const Rational f1 = f.at(to) - floor;
  const Rational g0 = g.at(from) - floor;
  const Rational g1 = g.at(to) - floor;
  const Rational gap0 = f0 - g0;
  const Rational gap1 = f1 - g1;
  const Rational width = to - from;
  if (sgn(gap0) * sgn(gap1) >= 0) return (std::min(f0, g0) + std::min(f1, g1)) * width / 2;
  // The lines cross in between: two trapezoids that meet there.
  const Rational part = gap0 / (gap0 - gap1);
  const Rational height = f0 + (f1 - f0) * part;
  return ((std::min(f0, g0) + height) * part + (height + std::min(f1, g1)) * (1 - part)) * width / 2;
}

}  // namespace

Rational trapezoid_area(std::span<const Point> points) {
  std::vector<Rational> terms;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& a = points[i];
    const Point& b = points[(i + 1) % points.size()];
    terms.push_back((Rational(a.x) - Rational(b.x)) * (Rational(a.y) + Rational(b.y)));
  }
  return sum(std::move(terms)) / 2;
}

Rational trapezoid_intersection(std::span<const Point> first, std::span<const Point> second) {
  Rational floor = first.empty() ? 0 : first.front().y;
  for (const auto points : {first, second}) {
    for (const Point& point : points) floor = std::min(floor, Rational(point.y));
  }
  const std::vector<Edge> edges1 = edges_of(first);
  const std::vector<Edge> edges2 = edges_of(second);
  std::vector<Rational> terms;
  for (const Edge& f : edges1) {
    for (const Edge& g : edges2) {
      if (f.left >= g.right || g.left >= f.right) continue;
      const Rational area = common_area(f, g, floor);
      terms.push_back(f.sign == g.sign ? area : -area);
    }
  }
  return sum(std::move(terms));
}

}  // namespace lober::oracle
