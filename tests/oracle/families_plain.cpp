// Families without designed contacts, and those on small integer grids, where contacts abound.
#include <cmath>
#include <cstddef>
#include <numbers>

#include "tests/oracle/families.hpp"

namespace lober::oracle::family {
namespace {

Point random_shift(Random& random, int size) {
  return {double(random.integer(-size, size)), double(random.integer(-size, size))};
}

}  // namespace

PolygonPair stars(Random& random) {
  const auto one = [&] {
    const Point centre{random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)};
    return star(random, random.integer(3, 20), centre, random.uniform(0.05, 0.9), 1);
  };
  return {one(), one()};
}

PolygonPair scattered_points(Random& random) {
  return {scattered(random, random.integer(3, 16)), scattered(random, random.integer(3, 16))};
}

PolygonPair mixed(Random& random) {
  return {any_shape(random), any_shape(random)};
}

PolygonPair wavy(Random& random) {
  const int count = random.integer(20, 90);
  const int waves = random.integer(2, count / 3);
  const double height = random.log_uniform(1e-3, 0.3);
  const double phase = random.uniform(0, 1);
  Polygon wave;
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * std::numbers::pi * (k + phase) / count;
    const double radius = 1 + height * std::sin(waves * angle);
    wave.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return {wave, star(random, random.integer(20, 90), {random.uniform(-0.05, 0.05), 0}, 0.98, 1)};
}

PolygonPair lattice(Random& random) {
  const int size = random.integer(2, 6);
  const int most = std::min(12, (size + 1) * (size + 1) - 2);
  return {on_lattice(random, random.integer(3, most), size), on_lattice(random, random.integer(3, most), size)};
}

PolygonPair polyominoes(Random& random) {
  return {polyomino(random, random.integer(1, 20)),
          moved(polyomino(random, random.integer(1, 20)), {1, 1}, random_shift(random, 2))};
}

PolygonPair rectangles(Random& random) {
  const int size = random.integer(2, 6);
  return {rectangle(random, size), rectangle(random, size)};
}

PolygonPair combs(Random& random) {
  const bool lattice_points = random.chance(0.5);
  const Polygon upright = comb(random, random.integer(1, 5), lattice_points);
  Polygon other = comb(random, random.integer(1, 5), lattice_points);
  const int turn = random.integer(0, 3);
  for (int k = 0; k < turn; ++k) {
    for (Point& point : other) point = {-point.y, point.x};
  }
  double low_x = 0;
  double low_y = 0;
  for (const Point& point : other) {
    low_x = std::min(low_x, point.x);
    low_y = std::min(low_y, point.y);
  }
  const Point shift =
      lattice_points ? random_shift(random, 2) : Point{random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2)};
  return {upright, moved(other, {1, 1}, {shift.x - low_x, shift.y - low_y})};
}

PolygonPair spirals(Random& random) {
  const Polygon first = spiral(random, random.uniform(1, 3));
  if (random.chance(0.3)) return {first, star(random, random.integer(3, 12), {0, 0}, 0.2, 1.4)};
  const Point shift = random.chance(0.5) ? Point{} : Point{random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3)};
  return {first, moved(spiral(random, random.uniform(1, 3)), {random.chance(0.5) ? 1.0 : -1.0, 1}, shift)};
}

PolygonPair nested(Random& random) {
  const Point centre{random.uniform(-1, 1), random.uniform(-1, 1)};
  const Polygon outer = star(random, random.integer(4, 14), centre, 0.5, 1);
  const double size = random.log_uniform(1e-6, 0.2);
  const Polygon inner = star(random, random.integer(3, 14), centre, 0.3 * size, size);
  return random.chance(0.5) ? PolygonPair{outer, inner} : PolygonPair{inner, outer};
}

PolygonPair disjoint(Random& random) {
  const Polygon first = any_shape(random);
  if (random.chance(0.5))
    return {first, moved(any_shape(random), {1, 1}, {random.uniform(1.5, 3), random.uniform(-1, 1)})};
  // Side by side in a concave place: boxes meet, curves mostly do not.
  const double size = random.log_uniform(1e-3, 0.1);
  return {first, star(random, random.integer(3, 10), {random.unit(), random.unit()}, 0.3 * size, size)};
}

}  // namespace lober::oracle::family
