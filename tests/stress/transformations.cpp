#include "tests/stress/transformations.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

namespace lober::stress {
namespace {

using oracle::CurvePair;
using oracle::Polygon;
using oracle::Random;

template <typename Map>
CurvePair mapped(const CurvePair& pair, const Map& map) {
  CurvePair result = pair;
  for (Polygon* polygon : {&result.first, &result.second}) {
    for (Point& point : *polygon) point = map(point);
  }
  return result;
}

bool same_points(const CurvePair& a, const CurvePair& b) {
  return a.first == b.first && a.second == b.second;
}

double size_of(const CurvePair& pair) {
  Point low = pair.first.front(), high = low;
  for (const Polygon* polygon : {&pair.first, &pair.second}) {
    for (const Point& point : *polygon) {
      low = {std::min(low.x, point.x), std::min(low.y, point.y)};
      high = {std::max(high.x, point.x), std::max(high.y, point.y)};
    }
  }
  return std::max(high.x - low.x, high.y - low.y);
}

double sign(Random& random) {
  return random.chance(0.5) ? 1 : -1;
}

Transformed nothing(const CurvePair& pair, Random&) {
  return {pair, true, 0};
}

// By up to 1e6 times the size. A sum of doubles is exact if and only if taking either term away leaves the other.
Transformed move_by(const CurvePair& pair, Point shift) {
  const CurvePair there = mapped(pair, [&](const Point& p) { return Point{p.x + shift.x, p.y + shift.y}; });
  const CurvePair back = mapped(there, [&](const Point& p) { return Point{p.x - shift.x, p.y - shift.y}; });
  bool exact = same_points(pair, back);
  for (const auto& [before, after] : {std::pair(&pair.first, &there.first), std::pair(&pair.second, &there.second)}) {
    for (std::size_t k = 0; k < before->size(); ++k) {
      const Point &p = (*before)[k], &q = (*after)[k];
      exact = exact && q.x - p.x == shift.x && q.y - p.y == shift.y;
    }
  }
  return {there, exact, 0};
}

Transformed move(const CurvePair& pair, Random& random) {
  const double size = size_of(pair);
  const auto shift = [&] { return sign(random) * size * random.log_uniform(1e-3, 1e6); };
  const double x = shift();
  return move_by(pair, {x, shift()});
}

// Shifts of few digits: exact for the curves whose coordinates have few.
Transformed move_on_grid(const CurvePair& pair, Random& random) {
  const double step = std::exp2(std::ilogb(size_of(pair)));
  const auto shift = [&] { return sign(random) * step * std::floor(random.log_uniform(1, 0x1p19)); };
  const double x = shift();
  return move_by(pair, {x, shift()});
}

// Curves that are large already only shrink: their areas have to stay finite.
double largest_factor(const CurvePair& pair) {
  return size_of(pair) > 1e100 ? 1 : 1e8;
}

Transformed scale(const CurvePair& pair, Random& random) {
  const double factor = random.log_uniform(1e-8, largest_factor(pair));
  return {mapped(pair, [&](const Point& p) { return Point{factor * p.x, factor * p.y}; }), false, 0};
}

Transformed scale_by_power_of_two(const CurvePair& pair, Random& random) {
  const int exponent = std::ilogb(random.log_uniform(1e-8, largest_factor(pair)));
  const auto by = [](int power) {
    return [power](const Point& p) { return Point{std::ldexp(p.x, power), std::ldexp(p.y, power)}; };
  };
  const CurvePair there = mapped(pair, by(exponent));
  return {there, same_points(pair, mapped(there, by(-exponent))), exponent};
}

Transformed rotate(const CurvePair& pair, Random& random) {
  const double angle = random.uniform(0, 2 * std::numbers::pi), c = std::cos(angle), s = std::sin(angle);
  return {mapped(pair, [&](const Point& p) { return Point{c * p.x - s * p.y, s * p.x + c * p.y}; }), false, 0};
}

Transformed quarter_turn(const CurvePair& pair, Random&) {
  return {mapped(pair, [](const Point& p) { return Point{-p.y, p.x}; }), true, 0};
}

// Each coordinate by at most three units in its last place; that of 0 is the smallest double.
Transformed jitter(const CurvePair& pair, Random& random) {
  const auto moved = [&](double value) {
    const double towards = sign(random) * HUGE_VAL;
    for (int ulps = random.integer(0, 3); ulps > 0; --ulps) value = std::nextafter(value, towards);
    return value;
  };
  return {mapped(pair,
                 [&](const Point& p) {
                   const double x = moved(p.x);
                   return Point{x, moved(p.y)};
                 }),
          false, 0};
}

// The first curve, the second, or both.
Transformed reverse(const CurvePair& pair, Random& random) {
  Transformed result{pair, true, 0};
  const int which = random.integer(1, 3);
  if ((which & 1) != 0) std::reverse(result.pair.first.begin(), result.pair.first.end());
  if ((which & 2) != 0) std::reverse(result.pair.second.begin(), result.pair.second.end());
  return result;
}

Transformed restart(const CurvePair& pair, Random& random) {
  Transformed result{pair, true, 0};
  for (Polygon* polygon : {&result.pair.first, &result.pair.second}) {
    const auto start = static_cast<std::ptrdiff_t>(random.index(polygon->size()));
    std::rotate(polygon->begin(), polygon->begin() + start, polygon->end());
  }
  return result;
}

Transformed repeat_vertices(const CurvePair& pair, Random& random) {
  Transformed result{pair, true, 0};
  for (Polygon* polygon : {&result.pair.first, &result.pair.second}) {
    Polygon repeated;
    for (const Point& point : *polygon) repeated.insert(repeated.end(), random.chance(0.3) ? 3U : 1U, point);
    *polygon = repeated;
  }
  return result;
}

double middle(double a, double b) {
  return 0.5 * a + 0.5 * b;
}

bool is_exact_middle(double a, double b) {
  // The halves are exact unless they underflow; the sum is, if taking either term away leaves the other.
  const double half_a = 0.5 * a, half_b = 0.5 * b, sum = half_a + half_b;
  return 2 * half_a == a && 2 * half_b == b && sum - half_a == half_b && sum - half_b == half_a;
}

Transformed subdivided(const CurvePair& pair, Random& random, bool only_exact) {
  Transformed result{pair, true, 0};
  for (Polygon* polygon : {&result.pair.first, &result.pair.second}) {
    Polygon divided;
    for (std::size_t k = 0; k < polygon->size(); ++k) {
      const Point &a = (*polygon)[k], &b = (*polygon)[k + 1 == polygon->size() ? 0 : k + 1];
      divided.push_back(a);
      const bool exact = is_exact_middle(a.x, b.x) && is_exact_middle(a.y, b.y);
      if (random.chance(0.3) || (only_exact && !exact)) continue;
      divided.push_back({middle(a.x, b.x), middle(a.y, b.y)});
      result.exact = result.exact && exact;
    }
    *polygon = divided;
  }
  return result;
}

Transformed subdivide(const CurvePair& pair, Random& random) {
  return subdivided(pair, random, false);
}

Transformed subdivide_exactly(const CurvePair& pair, Random& random) {
  return subdivided(pair, random, true);
}

constexpr std::array all{
    Transformation{"as generated", nothing},
    Transformation{"move", move},
    Transformation{"move on a grid", move_on_grid},
    Transformation{"scale", scale},
    Transformation{"scale by 2^k", scale_by_power_of_two},
    Transformation{"rotate", rotate},
    Transformation{"quarter turn", quarter_turn},
    Transformation{"jitter", jitter},
    Transformation{"reverse", reverse},
    Transformation{"restart", restart},
    Transformation{"repeat vertices", repeat_vertices},
    Transformation{"subdivide", subdivide},
    Transformation{"subdivide exactly", subdivide_exactly},
};

}  // namespace

std::span<const Transformation> transformations() {
  return all;
}

Transformed transformed(const CurvePair& pair, const Transformation& transformation) {
  const auto number = static_cast<std::uint64_t>(&transformation - all.data());
  Random random(Random(pair.seed).bits() + number);
  Transformed result = transformation.apply(pair, random);
  result.pair.family += ", " + std::string(transformation.name);
  return result;
}

}  // namespace lober::stress
