#include "tests/oracle/crossing_polygons.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lober::oracle {
namespace {

bool usable(const Polygon& polygon) {
  for (const Point& p : polygon) {
    for (const Point& q : polygon) {
      if (p != polygon[0] && q != polygon[0] && p != q) return true;
    }
  }
  return false;
}

// Tries until the polygon has three distinct vertices.
template <typename Make>
Polygon until_usable(const Make& make) {
  while (true) {
    Polygon polygon = make();
    if (usable(polygon)) return polygon;
  }
}

Polygon lattice(Random& random, int least, int most, int size) {
  return until_usable([&] {
    Polygon polygon(static_cast<std::size_t>(random.integer(least, most)));
    for (Point& p : polygon) p = {double(random.integer(0, size)), double(random.integer(0, size))};
    return polygon;
  });
}

Polygon scattered_doubles(Random& random, int least, int most) {
  Polygon polygon(static_cast<std::size_t>(random.integer(least, most)));
  for (Point& p : polygon) p = {random.uniform(-1, 1), random.uniform(-1, 1)};
  return polygon;
}

// A closed walk along the lines of the lattice, mostly straight on or back.
Polygon lattice_walk(Random& random, int least, int most) {
  return until_usable([&] {
    Polygon polygon{{0, 0}};
    for (int left = random.integer(least, most); left > 0; --left) {
      Point p = polygon.back();
      (random.chance(0.5) ? p.x : p.y) += random.integer(-2, 2);
      p.x = std::clamp(p.x, -2.0, 2.0);
      p.y = std::clamp(p.y, -2.0, 2.0);
      polygon.push_back(p);
    }
    polygon.push_back({polygon.back().x, 0});
    return polygon;
  });
}

Polygon with_spikes(Random& random, const Polygon& polygon) {
  Polygon result;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point p = polygon[k];
    result.push_back(p);
    if (!random.chance(0.4)) continue;
    // Out and back, sometimes along the next side or the last one, sometimes not all the way.
    const Point next = polygon[(k + 1) % polygon.size()], last = polygon[(k + polygon.size() - 1) % polygon.size()];
    const Point any{p.x + 2 * random.integer(-2, 2), p.y + 2 * random.integer(-2, 2)};
    const Point end = random.chance(0.3) ? next : random.chance(0.3) ? last : any;
    result.push_back(end);
    result.push_back(random.chance(0.3) ? Point{0.5 * (p.x + end.x), 0.5 * (p.y + end.y)} : p);
  }
  return result;
}

Polygon with_repeats(Random& random, const Polygon& polygon) {
  Polygon result;
  for (const Point& p : polygon) {
    for (int left = random.chance(0.5) ? 1 : random.integer(1, 3); left > 0; --left) result.push_back(p);
  }
  return result;
}

Polygon rearranged(Random& random, Polygon polygon) {
  if (random.chance(0.5)) std::reverse(polygon.begin(), polygon.end());
  std::rotate(polygon.begin(), polygon.begin() + static_cast<std::ptrdiff_t>(random.index(polygon.size())),
              polygon.end());
  return polygon;
}

Polygon regular_star(Random& random) {
  constexpr std::array<std::array<int, 2>, 6> kinds{{{5, 2}, {7, 2}, {7, 3}, {8, 3}, {6, 2}, {9, 4}}};
  const auto [corners, step] = kinds[random.index(kinds.size())];
  const double turn = random.uniform(0, 6), size = random.chance(0.5) ? 1 : random.uniform(0.2, 2);
  const bool rounded = random.chance(0.4);
  const int back = random.chance(0.5) ? 1 : -1;
  return until_usable([&, corners = corners, step = step] {
    Polygon polygon;
    for (int k = 0; k < corners; ++k) {
      const double angle = turn + back * 2 * std::numbers::pi * k * step / corners;
      Point p{size * std::cos(angle), size * std::sin(angle)};
      if (rounded) p = {std::round(5 * p.x), std::round(5 * p.y)};
      polygon.push_back(p);
    }
    return polygon;
  });
}

// A circle wound several times, onto itself or to a slightly different one, or once there and back.
Polygon wound(Random& random) {
  const int corners = random.integer(3, 5), turns = random.integer(2, 3);
  const bool exact = random.chance(0.6);
  const Polygon once = exact ? lattice(random, 3, 5, 4) : star(random, corners, {0, 0}, 0.5, 1);
  Polygon polygon;
  for (int k = 0; k < turns; ++k) {
    Polygon next = once;
    if (random.chance(0.25)) std::reverse(next.begin(), next.end());
    if (!exact && random.chance(0.5)) {
      for (Point& p : next) p = {p.x * 1.01, p.y * 0.99};
    }
    polygon.insert(polygon.end(), next.begin(), next.end());
  }
  return polygon;
}

// Sides that pass through the origin, inside them; differences of their coordinates need not be doubles.
Polygon pencil(Random& random) {
  Polygon polygon;
  const bool fine = random.chance(0.5);
  const int size = fine ? 1 << 26 : 40;
  for (int left = random.integer(2, 4); left > 0; --left) {
    const Point p{double(random.integer(-size, size)), double(random.integer(1, size))};
    const double scale = fine ? std::ldexp(random.integer(1, 1 << 20), -random.integer(18, 40)) : random.integer(1, 3);
    polygon.push_back(p);
    polygon.push_back({-scale * p.x, -scale * p.y});
  }
  return polygon;
}

Polygon figure_eight(Random& random) {
  const auto coordinate = [&] { return random.chance(0.5) ? double(random.integer(1, 4)) : random.uniform(0.5, 4); };
  const double a = coordinate(), b = coordinate(), c = coordinate(), d = coordinate();
  return rearranged(random, {{-a, -b}, {c, d}, {c, -d}, {-a, b}});
}

Polygon jittered(Random& random, Polygon polygon) {
  for (Point& p : polygon) {
    if (random.chance(0.5)) continue;
    double& coordinate = random.chance(0.5) ? p.x : p.y;
    coordinate = std::nextafter(coordinate, random.chance(0.5) ? 10 : -10);
  }
  return polygon;
}

Polygon any_crossing(Random& random) {
  switch (random.integer(0, 4)) {
    case 0:
      return lattice(random, 3, 7, 4);
    case 1:
      return scattered_doubles(random, 3, 6);
    case 2:
      return figure_eight(random);
    case 3:
      return wound(random);
    default:
      return regular_star(random);
  }
}

PolygonPair lattices(Random& random) {
  const int size = random.integer(2, 7);
  return {lattice(random, 3, 9, size), lattice(random, 3, 9, size)};
}
PolygonPair doubles(Random& random) {
  return {scattered_doubles(random, 3, 7), scattered_doubles(random, 3, 6)};
}
PolygonPair figure_eights(Random& random) {
  return {figure_eight(random), random.chance(0.5) ? figure_eight(random) : any_crossing(random)};
}
PolygonPair stars(Random& random) {
  return {regular_star(random), random.chance(0.5) ? regular_star(random) : lattice(random, 3, 5, 3)};
}
PolygonPair spikes(Random& random) {
  return {with_spikes(random, lattice(random, 3, 6, 5)),
          random.chance(0.5) ? lattice(random, 3, 6, 5) : with_spikes(random, lattice(random, 3, 5, 5))};
}
PolygonPair repeats(Random& random) {
  return {with_repeats(random, lattice(random, 3, 7, 4)), with_repeats(random, lattice(random, 3, 6, 4))};
}
PolygonPair windings(Random& random) {
  return {wound(random), any_crossing(random)};
}
PolygonPair same(Random& random) {
  Polygon polygon = any_crossing(random);
  Polygon other = rearranged(random, polygon);
  return {std::move(polygon), std::move(other)};
}
PolygonPair shared_chains(Random& random) {
  const Polygon first = random.chance(0.5) ? lattice(random, 4, 8, 6) : scattered_doubles(random, 4, 7);
  const Polygon second = until_usable([&] {
    Polygon polygon(first.begin() + 1, first.end() - 1);
    if (random.chance(0.5)) std::reverse(polygon.begin(), polygon.end());
    for (int left = random.integer(1, 3); left > 0; --left) {
      polygon.push_back({double(random.integer(0, 6)), double(random.integer(0, 6))});
    }
    return polygon;
  });
  return {first, second};
}
PolygonPair walks(Random& random) {
  return {lattice_walk(random, 4, 9), lattice_walk(random, 4, 8)};
}
PolygonPair apart(Random& random) {
  const Polygon first = any_crossing(random), second = any_crossing(random);
  const double scale = std::exp2(random.integer(-5, 5));
  const double reach = std::max(scale, 1.0) * 2;
  const bool whole = random.chance(0.7);
  const auto shift = [&] { return whole ? std::round(random.uniform(-reach, reach)) : random.uniform(-reach, reach); };
  return {first, moved(second, {scale, scale}, {shift(), random.chance(0.5) ? 0 : shift()})};
}
PolygonPair pencils(Random& random) {
  return {until_usable([&] { return pencil(random); }), until_usable([&] { return pencil(random); })};
}
PolygonPair ulps(Random& random) {
  const Polygon first = scattered_doubles(random, 3, 6);
  Polygon twice = first;
  const Polygon again = jittered(random, first);
  if (random.chance(0.4)) twice.insert(twice.end(), again.begin(), again.end());
  return {twice, jittered(random, first)};
}
PolygonPair extremes(Random& random) {
  const PolygonPair pair = random.chance(0.7) ? lattices(random) : spikes(random);
  const double scale = std::exp2(random.chance(0.5) ? random.integer(-505, -400) : random.integer(400, 505));
  return {moved(pair.first, {scale, scale}, {0, 0}), moved(pair.second, {scale, scale}, {0, 0})};
}
// Coordinates of all sizes in one polygon; differences and areas underflow.
PolygonPair log_scales(Random& random) {
  const double least = std::exp2(-random.integer(20, 800));
  const auto coordinate = [&] {
    if (random.chance(0.2)) return 0.0;
    const double size = random.log_uniform(least, 1);
    return random.chance(0.5) ? size : -size;
  };
  const auto polygon = [&] {
    Polygon points(static_cast<std::size_t>(random.integer(3, 5)));
    for (Point& p : points) p = {coordinate(), coordinate()};
    return points;
  };
  return {until_usable(polygon), until_usable(polygon)};
}
PolygonPair mixed(Random& random) {
  Polygon first = any_crossing(random);
  const Polygon more = any_crossing(random);
  if (first.size() + more.size() < 14) first.insert(first.end(), more.begin(), more.end());
  return {first, with_repeats(random, any_crossing(random))};
}

}  // namespace

const std::array<CrossingFamily, 16>& crossing_families() {
  static constexpr std::array<CrossingFamily, 16> families{{{"lattices", lattices},
                                                            {"doubles", doubles},
                                                            {"figure_eights", figure_eights},
                                                            {"stars", stars},
                                                            {"spikes", spikes},
                                                            {"repeats", repeats},
                                                            {"windings", windings},
                                                            {"same", same},
                                                            {"shared_chains", shared_chains},
                                                            {"walks", walks},
                                                            {"apart", apart},
                                                            {"pencils", pencils},
                                                            {"ulps", ulps},
                                                            {"extremes", extremes},
                                                            {"log_scales", log_scales},
                                                            {"mixed", mixed}}};
  return families;
}

}  // namespace lober::oracle
