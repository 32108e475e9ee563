// Families that share arcs, lines and vertices, exactly or to the last bit.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "tests/oracle/families.hpp"

namespace lober::oracle::family {
namespace {

// Several arcs of a star with some vertices moved in or out; the others are the same doubles. `detail`
// may be different on both: an arc that is not shared gets vertices of its own.
Polygon rerouted(Random& random, const Polygon& original, double keep) {
  Polygon result;
  bool kept = random.chance(0.5);
  for (const Point& point : original) {
    if (random.chance(0.3)) kept = random.chance(keep);
    const double factor = kept ? 1 : random.uniform(0.6, 1.5);
    if (kept || random.chance(0.8)) result.push_back({point.x * factor, point.y * factor});
  }
  return result;
}

// Noise of one ulp; at zero that is the smallest number there is, or an ulp of the rest.
Polygon nudged(Random& random, const Polygon& polygon) {
  const double often = random.chance(0.3) ? 1 : random.unit();
  const auto noise = [&](double value) {
    if (!random.chance(often)) return value;
    if (value == 0 && random.chance(0.5)) return random.chance(0.5) ? 0x1p-53 : -0x1p-53;
    const double infinity = std::numeric_limits<double>::infinity();
    return std::nextafter(value, random.chance(0.5) ? infinity : -infinity);
  };
  Polygon result;
  for (const Point& point : polygon) {
    const double x = noise(point.x);
    result.push_back({x, noise(point.y)});
  }
  return result;
}

// A border from bottom to top, and a country on either side of it. Each keeps a part of the border.
PolygonPair neighbours(Random& random, bool on_grid) {
  const int count = random.integer(3, 10);
  const double unit = on_grid ? 4 : 1.0 / count;
  Polygon border;
  for (int k = 0; k < count; ++k) {
    const double x = on_grid ? 4 * random.integer(-1, 1) : random.uniform(-0.3, 0.3);
    border.push_back({x, k * unit});
  }
  const auto country = [&](double away) {
    const int last = random.integer(1, count - 1);
    const int first = random.integer(0, last - 1);
    Polygon polygon(border.begin() + first, border.begin() + last + 1);
    const int corners = random.integer(1, 4);
    for (int k = 0; k < corners; ++k) {
      const double x = on_grid ? 4 * random.integer(2, 4) : random.uniform(0.4, 1);
      const double t = (k + (on_grid ? 0.5 : random.unit())) / corners;
      const double y = (last + t * (first - last)) * unit;
      polygon.push_back({away * x, on_grid ? 4 * std::round(y / 4) : y});
    }
    // A country that has not quite agreed on the border: crossings beside shared arcs.
    if (random.chance(0.3)) polygon[random.index(polygon.size())].x += on_grid ? 4 : 0.05;
    return polygon;
  };
  Polygon left = country(-1);
  return {left, country(random.chance(0.8) ? 1 : -1)};
}

Polygon scaled_lattice_shape(Random& random, double factor) {
  return moved(any_lattice_shape(random), {factor, factor}, {});
}

Point along(const Polygon& polygon, std::size_t segment, double t) {
  const Point& a = polygon[segment];
  const Point& b = polygon[(segment + 1) % polygon.size()];
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

}  // namespace

PolygonPair collinear(Random& random) {
  // On multiples of 8 the eighths of a segment are exact.
  const Polygon first = scaled_lattice_shape(random, 8);
  Polygon second;
  for (int lines = random.integer(1, 2); lines > 0; --lines) {
    const std::size_t segment = random.index(first.size());
    const int from = random.integer(-8, 15);
    second.push_back(along(first, segment, from / 8.0));
    second.push_back(along(first, segment, random.integer(from + 1, 16) / 8.0));
  }
  for (int more = random.integer(1, 3); more > 0; --more) {
    second.push_back({double(random.integer(-8, 64)), double(random.integer(-8, 64))});
  }
  return {first, random.chance(0.7) ? second : untangled(second)};
}

PolygonPair shared_same_way(Random& random) {
  const Polygon first = star(random, random.integer(4, 20), {0, 0}, 0.4, 1);
  const Polygon second = rerouted(random, first, random.uniform(0.2, 0.9));
  return {rerouted(random, first, 0.9), second};
}

PolygonPair shared_border(Random& random) {
  return neighbours(random, false);
}

PolygonPair shared_on_lattice(Random& random) {
  PolygonPair pair;
  if (random.chance(0.5)) {
    pair = neighbours(random, true);
  } else {
    // The same outline with some vertices moved elsewhere on the lattice or left out.
    pair.first = scaled_lattice_shape(random, 4);
    for (const Point& point : pair.first) {
      const int what = random.integer(0, 9);
      if (what == 0) continue;
      const double step = what == 1 ? 4 : 0;
      pair.second.push_back({point.x + step * random.integer(-1, 1), point.y + step * random.integer(-1, 1)});
    }
  }
  const double often = random.unit();
  return {with_midpoints(random, with_midpoints(random, pair.first, often), often),
          with_midpoints(random, with_midpoints(random, pair.second, often), 0.5)};
}

PolygonPair shared_to_one_ulp(Random& random) {
  const int kind = random.integer(0, 2);
  PolygonPair pair = kind == 0 ? shared_same_way(random) : kind == 1 ? shared_border(random) : identical(random);
  if (kind == 2) {
    // Away from the lattice, where an ulp is the same for many coordinates.
    const Point scale{random.uniform(0.1, 1), random.uniform(0.1, 1)};
    pair = {moved(pair.first, scale, {}), moved(pair.second, scale, {})};
  }
  return {pair.first, nudged(random, pair.second)};
}

PolygonPair identical(Random& random) {
  if (random.chance(0.3)) {
    const Polygon polygon = any_shape(random);
    return {polygon, polygon};
  }
  const Polygon polygon = scaled_lattice_shape(random, 4);
  return {with_midpoints(random, polygon, random.unit()),
          with_midpoints(random, with_midpoints(random, polygon, 0.5), 0.5)};
}

PolygonPair touching(Random& random) {
  // A small polygon with one vertex on the other curve: on a vertex, or inside a segment.
  const Polygon first = scaled_lattice_shape(random, 8);
  const std::size_t segment = random.index(first.size());
  const Point contact = along(first, segment, random.chance(0.5) ? 0 : random.integer(1, 7) / 8.0);
  const double direction = random.uniform(0, 2 * std::numbers::pi);
  const double spread = random.uniform(0.1, 1.5);
  Polygon second{contact};
  const int corners = random.integer(2, 5);
  for (int k = 0; k < corners; ++k) {
    const double angle = direction + spread * k / (corners - 1);
    const double radius = random.log_uniform(0.01, 6);
    second.push_back({contact.x + radius * std::cos(angle), contact.y + radius * std::sin(angle)});
  }
  return {first, second};
}

PolygonPair inscribed(Random& random) {
  // Vertices of the second curve are vertices or exact points of the first.
  const bool on_grid = random.chance(0.6);
  const Polygon first = on_grid ? scaled_lattice_shape(random, 8) : any_shape(random);
  Polygon second;
  for (std::size_t k = 0; k < first.size(); ++k) {
    const int eighths = on_grid && random.chance(0.3) ? random.integer(1, 7) : 0;
    if (random.chance(0.7)) second.push_back(along(first, k, eighths / 8.0));
  }
  const int more = random.integer(0, 3);
  for (int k = 0; k < more; ++k) second.push_back({random.uniform(-4, 40), random.uniform(-4, 40)});
  return {first, random.chance(0.5) ? second : untangled(second)};
}

}  // namespace lober::oracle::family
