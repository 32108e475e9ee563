// Families at unusual scales: per polygon, per axis, per vertex; thin, far away, near underflow and overflow.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "tests/oracle/families.hpp"

namespace lober::oracle::family {
namespace {

PolygonPair any_pair(Random& random) {
  switch (random.integer(0, 5)) {
    case 0:
      return lattice(random);
    case 1:
      return shared_same_way(random);
    case 2:
      return polyominoes(random);
    case 3:
      return shared_border(random);
    default:
      return mixed(random);
  }
}

PolygonPair moved_both(const PolygonPair& pair, Point scale, Point shift) {
  return {moved(pair.first, scale, shift), moved(pair.second, scale, shift)};
}

double random_sign(Random& random) {
  return random.chance(0.5) ? 1 : -1;
}

}  // namespace

PolygonPair own_scales(Random& random) {
  // The place where the curves are to meet becomes the origin, so that both scales keep their digits there.
  Polygon first = any_shape(random);
  const std::size_t k = random.index(first.size());
  const double t = random.chance(0.5) ? 0 : random.unit();
  const Point& a = first[k];
  const Point& b = first[(k + 1) % first.size()];
  const Point origin{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
  const double scale1 = random.log_uniform(1e-15, 1e15);
  const double scale2 = random.chance(0.5) ? random.log_uniform(1e-15, 1e15) : scale1 * random.log_uniform(1e-3, 1e3);
  first = moved(moved(first, {1, 1}, {-origin.x, -origin.y}), {scale1, scale1}, {});
  return {first, moved(any_shape(random), {scale2, scale2}, {-0.5 * scale2, -0.5 * scale2})};
}

PolygonPair anisotropic(Random& random) {
  const Point scale{random.log_uniform(1e-15, 1e15), random.log_uniform(1e-15, 1e15)};
  return moved_both(any_pair(random), scale, {});
}

PolygonPair log_uniform(Random& random) {
  const auto one = [&] {
    // Sorted by angle about the origin within each quadrant, by slopes and not by rounded angles.
    Polygon polygon;
    const double low = random.log_uniform(1e-15, 1e3);
    const double high = random.log_uniform(std::max(low, 1e-3), 1e15);
    for (const Point quadrant : {Point{1, 1}, Point{-1, 1}, Point{-1, -1}, Point{1, -1}}) {
      Polygon part;
      for (int count = random.integer(1, 3); count > 0; --count) {
        part.push_back({quadrant.x * random.log_uniform(low, high), quadrant.y * random.log_uniform(low, high)});
      }
      const double way = quadrant.x * quadrant.y;
      std::sort(part.begin(), part.end(), [&](const Point& a, const Point& b) {
        return way * std::abs(a.y) / std::abs(a.x) < way * std::abs(b.y) / std::abs(b.x);
      });
      polygon.insert(polygon.end(), part.begin(), part.end());
    }
    return polygon;
  };
  return {one(), one()};
}

PolygonPair slivers(Random& random) {
  const Point a{random.unit(), random.unit()};
  const Point b{random.unit(), random.unit()};
  const Polygon first = needle(random, a, b, random.log_uniform(1e-16, 1e-1));
  const double width = random.log_uniform(1e-16, 1e-1);
  switch (random.integer(0, 3)) {
    case 0:
      return {first, needle(random, {random.unit(), random.unit()}, {random.unit(), random.unit()}, width)};
    case 1: {
      // Nearly along the first one.
      const auto near = [&](Point p) {
        const double size = random.log_uniform(1e-16, 1e-1);
        return Point{p.x + size * random.uniform(-1, 1), p.y + size * random.uniform(-1, 1)};
      };
      const Point c = near(a);
      return {first, needle(random, c, near(b), width)};
    }
    case 2:
      return {first, any_shape(random)};
    default: {
      // A point, a hair's breadth from a side.
      const double t = random.unit();
      const Point end{a.x + t * (b.x - a.x) + width * random_sign(random), a.y + t * (b.y - a.y)};
      return {first, {end, {random.unit(), random.unit()}, {random.unit(), random.unit()}}};
    }
  }
}

PolygonPair far_away(Random& random) {
  const double size = random.log_uniform(1e-6, 1);
  const Point shift{1e6 * random_sign(random) * random.uniform(0.5, 1), 1e6 * random_sign(random) * random.unit()};
  return moved_both(any_pair(random), {size, size}, shift);
}

PolygonPair extreme_scale(Random& random) {
  const double scale = random.chance(0.8) ? 1e-300 : 1e150;
  return moved_both(any_pair(random), {scale, scale}, {});
}

// Coordinates of all sizes in one polygon: 0 and powers of 2^200, exactly or with digits behind.
PolygonPair powers_of_2_200(Random& random) {
  const int lowest = random.integer(-2, 1), highest = random.integer(lowest, 2);
  const bool exactly = random.chance(0.3);
  const auto coordinate = [&] {
    if (random.chance(0.15)) return 0.0;
    return random_sign(random) * std::ldexp(exactly ? 1 : random.uniform(1, 2), 200 * random.integer(lowest, highest));
  };
  const auto one = [&] {
    Polygon polygon(static_cast<std::size_t>(random.integer(3, 5)));
    for (Point& p : polygon) {
      p.x = coordinate();
      p.y = coordinate();
    }
    return polygon;
  };
  Polygon first = one(), second = one();
  // Common vertices, and a vertex of one on a level or an upright side of the other.
  if (random.chance(0.5)) second[random.index(second.size())] = first[random.index(first.size())];
  if (random.chance(0.3)) second[random.index(second.size())].x = first[random.index(first.size())].x;
  return {std::move(first), std::move(second)};
}

// One axis among the denormals, where a difference has few digits and every product of two is lost.
PolygonPair denormal_axis(Random& random) {
  const int digits = random.integer(2, 40);
  const bool upright = random.chance(0.5);
  const PolygonPair pair = any_pair(random);
  const auto flattened = [&](const Polygon& polygon) {
    Polygon result;
    for (const Point& p : polygon) {
      const double tiny = std::ldexp(std::round(std::ldexp(upright ? p.x : p.y, digits)), -1074);
      result.push_back(upright ? Point{tiny, p.y} : Point{p.x, tiny});
    }
    return result;
  };
  return {flattened(pair.first), flattened(pair.second)};
}

}  // namespace lober::oracle::family
