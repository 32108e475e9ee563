#include "tests/oracle/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <set>

#include "kernels/box.hpp"

namespace lober::oracle {
using namespace lober::detail;
namespace {

using Cell = std::pair<int, int>;

// The edges between a set of cells and the rest, counter-clockwise; empty if two of them start in one vertex.
std::map<Cell, Cell> outline_edges(const std::set<Cell>& cells) {
  std::map<Cell, Cell> edges;
  std::size_t count = 0;
  const auto add = [&](Cell outside, Cell from, Cell to) {
    if (cells.contains(outside)) return;
    edges[from] = to;
    ++count;
  };
  for (const auto& [x, y] : cells) {
    add({x, y - 1}, {x, y}, {x + 1, y});
    add({x + 1, y}, {x + 1, y}, {x + 1, y + 1});
    add({x, y + 1}, {x + 1, y + 1}, {x, y + 1});
    add({x - 1, y}, {x, y + 1}, {x, y});
  }
  if (edges.size() != count) edges.clear();
  return edges;
}

}  // namespace

Polygon star(Random& random, int count, Point centre, double near, double far) {
  Polygon polygon;
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * std::numbers::pi * (k + random.uniform(0, 0.8)) / count;
    const double radius = random.uniform(near, far);
    polygon.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  return polygon;
}

Polygon untangled(Polygon points) {
  // A tour that no exchange of two segments shortens has no crossing, by the triangle inequality.
  const std::size_t count = points.size();
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i + 2 < count; ++i) {
      for (std::size_t j = i + 2; j < count; ++j) {
        const Point& after = points[(j + 1) % count];
        const double now = distance(points[i], points[i + 1]) + distance(points[j], after);
        const double then = distance(points[i], points[j]) + distance(points[i + 1], after);
        if (then >= now * (1 - 1e-12)) continue;
        std::reverse(points.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                     points.begin() + static_cast<std::ptrdiff_t>(j) + 1);
        changed = true;
      }
    }
  }
  return points;
}

Polygon scattered(Random& random, int count) {
  Polygon points;
  for (int k = 0; k < count; ++k) points.push_back({random.unit(), random.unit()});
  return untangled(std::move(points));
}

Polygon on_lattice(Random& random, int count, int size) {
  Polygon points;
  while (points.size() < static_cast<std::size_t>(count)) {
    const Point point{double(random.integer(0, size)), double(random.integer(0, size))};
    if (std::find(points.begin(), points.end(), point) == points.end()) points.push_back(point);
  }
  return untangled(std::move(points));
}

Polygon polyomino(Random& random, int cells) {
  for (;;) {
    std::set<Cell> chosen{{0, 0}};
    std::vector<Cell> list{{0, 0}};
    while (list.size() < static_cast<std::size_t>(cells)) {
      auto [x, y] = list[random.index(list.size())];
      const int step = random.chance(0.5) ? 1 : -1;
      (random.chance(0.5) ? x : y) += step;
      if (chosen.insert({x, y}).second) list.push_back({x, y});
    }
    const auto edges = outline_edges(chosen);
    if (edges.empty()) continue;
    std::vector<Cell> cycle;
    Cell at = edges.begin()->first;
    do {
      cycle.push_back(at);
      at = edges.at(at);
    } while (at != edges.begin()->first);
    if (cycle.size() != edges.size()) continue;  // there are holes
    const double keep = random.chance(0.5) ? 0 : random.unit();
    Polygon polygon;
    for (std::size_t k = 0; k < cycle.size(); ++k) {
      const Cell before = cycle[(k + cycle.size() - 1) % cycle.size()];
      const Cell after = cycle[(k + 1) % cycle.size()];
      const bool straight = before.first == after.first || before.second == after.second;
      if (straight && !random.chance(keep)) continue;
      polygon.push_back({double(cycle[k].first), double(cycle[k].second)});
    }
    return polygon;
  }
}

Polygon rectangle(Random& random, int size) {
  const int left = random.integer(0, size - 1);
  const int low = random.integer(0, size - 1);
  const int right = random.integer(left + 1, size);
  const int high = random.integer(low + 1, size);
  const double keep = random.chance(0.5) ? 0 : random.unit();
  Polygon polygon;
  const auto side = [&](int x, int y, int step_x, int step_y, int length) {
    for (int k = 0; k < length; ++k) {
      if (k == 0 || random.chance(keep)) polygon.push_back({double(x + k * step_x), double(y + k * step_y)});
    }
  };
  side(left, low, 1, 0, right - left);
  side(right, low, 0, 1, high - low);
  side(right, high, -1, 0, right - left);
  side(left, high, 0, -1, high - low);
  return polygon;
}

Polygon spiral(Random& random, double turns) {
  const int steps = static_cast<int>(turns * 9) + 2;
  const double phase = random.uniform(0, 2 * std::numbers::pi);
  const double width = random.uniform(0.05, 0.9);
  Polygon polygon;
  const auto add = [&](int k, double offset) {
    const double angle = 2 * std::numbers::pi * turns * k / steps;
    const double radius = 0.3 + (angle / (2 * std::numbers::pi) + offset) / turns;
    polygon.push_back({radius * std::cos(angle + phase), radius * std::sin(angle + phase)});
  };
  for (int k = 0; k <= steps; ++k) add(k, 0);
  for (int k = steps; k >= 0; --k) add(k, width);
  return polygon;
}

Polygon comb(Random& random, int teeth, bool lattice) {
  const double size = lattice ? 2.0 * teeth : 1.0;
  const double pitch = size / (2 * teeth);
  const double base = lattice ? random.integer(1, 2) : random.uniform(0.05, 0.4);
  const auto jitter = [&] { return lattice ? 0.0 : random.uniform(0, 0.8) * pitch; };
  Polygon polygon{{0, 0}, {size, 0}};
  for (int k = teeth; k > 0; --k) {
    const double top = lattice ? base + random.integer(1, 2 * teeth) : random.uniform(base + 0.1, 1);
    const double right = (2 * k - 1) * pitch + jitter();
    const double left = (2 * k - 2) * pitch + (k == 1 ? 0.0 : jitter());
    if (k != teeth || right != size) polygon.push_back({right, base});
    polygon.push_back({right, top});
    polygon.push_back({left, top});
    if (k != 1) polygon.push_back({left, base});
  }
  polygon[1].x = polygon[2].x;  // no overhang right of the last tooth
  return polygon;
}

Polygon needle(Random& random, Point a, Point b, double width) {
  const double length = distance(a, b);
  const Point normal{(a.y - b.y) / length, (b.x - a.x) / length};
  const int steps = random.integer(1, 4);
  Polygon polygon;
  const auto add = [&](double t, double offset) {
    polygon.push_back({a.x + t * (b.x - a.x) + offset * normal.x, a.y + t * (b.y - a.y) + offset * normal.y});
  };
  for (int k = 0; k <= steps; ++k) add(double(k) / steps, 0.3 * width * random.unit());
  for (int k = steps; k >= 0; --k) {
    if ((k == 0 || k == steps) && random.chance(0.5)) continue;  // a pointed end
    add(double(k) / steps, width * random.uniform(0.5, 1));
  }
  return polygon;
}

Polygon any_shape(Random& random) {
  const Point centre{random.uniform(0.3, 0.7), random.uniform(0.3, 0.7)};
  switch (random.integer(0, 4)) {
    case 0:
      return star(random, random.integer(3, 14), centre, 0.1, 0.6);
    case 1:
      return star(random, random.integer(3, 14), centre, 0.4, 0.5);
    case 2:
      return comb(random, random.integer(1, 4), false);
    case 3:
      return moved(spiral(random, random.uniform(0.5, 1.5)), {0.4, 0.4}, centre);
    default:
      return scattered(random, random.integer(3, 12));
  }
}

Polygon any_lattice_shape(Random& random) {
  switch (random.integer(0, 4)) {
    case 0:
      return on_lattice(random, random.integer(3, 10), random.integer(3, 7));
    case 1:
      return rectangle(random, random.integer(2, 6));
    case 2:
      return comb(random, random.integer(1, 4), true);
    case 3: {
      const Polygon polygon = comb(random, random.integer(1, 4), true);
      Polygon turned;
      for (const Point& point : polygon) turned.push_back({-point.y, point.x});
      return moved(turned, {1, 1}, {double(random.integer(2, 8)), 0});
    }
    default:
      return polyomino(random, random.integer(1, 14));
  }
}

Polygon moved(const Polygon& polygon, Point scale, Point shift) {
  Polygon result;
  for (const Point& point : polygon) result.push_back({point.x * scale.x + shift.x, point.y * scale.y + shift.y});
  return result;
}

Polygon with_midpoints(Random& random, const Polygon& polygon, double probability) {
  Polygon result;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point& a = polygon[k];
    const Point& b = polygon[(k + 1) % polygon.size()];
    result.push_back(a);
    const bool even = std::fmod(a.x + b.x, 2) == 0 && std::fmod(a.y + b.y, 2) == 0;
    if (even && random.chance(probability)) result.push_back({(a.x + b.x) / 2, (a.y + b.y) / 2});
  }
  return result;
}

}  // namespace lober::oracle
