// Pairs of open curves for the tests of tangles.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "kernels/point.hpp"
#include "lober/curve/curve.hpp"
#include "tests/oracle/random.hpp"

namespace lober::detail {

struct ManifoldPair {
  std::vector<Point> u, s;
};

inline CurveView open(const std::vector<Point>& points) {
  return {points, false};
}

/// Two straight pieces that run towards each other, under different random shears, one after the other along x and y:
/// curves that fold and cross, in no particular position. Smooth and finely sampled, so that few cross themselves.
inline ManifoldPair random_manifolds(oracle::Random& random, std::size_t points, int shears) {
  const auto curve = [&](double side) {
    const Point from{side, random.uniform(-0.3, 0.3)}, to{-side, random.uniform(-0.3, 0.3)};
    std::vector<Point> list(points);
    for (std::size_t k = 0; k < points; ++k) {
      const double t = static_cast<double>(k) / static_cast<double>(points - 1);
      list[k] = {from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)};
    }
    for (int k = 0; k < shears; ++k) {
      const double a = random.uniform(-0.7, 0.7), b = random.uniform(1, 5), c = random.uniform(0, 6);
      for (Point& p : list) {
        if (k % 2 == 0) p.x += a * std::sin(b * p.y + c);
        if (k % 2 == 1) p.y += a * std::sin(b * p.x + c);
      }
    }
    return list;
  };
  std::vector<Point> u = curve(-2), s = curve(2);
  if (random.chance(0.7)) {  // homoclinic, so that there is no chord
    const Point start{random.uniform(-1, 1), -30};
    u.insert(u.begin(), start);
    s.insert(s.begin(), start);
  }
  return {std::move(u), std::move(s)};
}

/// U a sine wave along the x axis from the left, S its mirror image from the right with its fingers leaning to the
/// right by `lean` at height 1: crossings at whole x are pips, `lobes` + 1 of them, and lobe j meets later lobes. Both
/// come from far below, where their chord is out of the way.
inline ManifoldPair leaning_fingers(int lobes, std::size_t points_per_lobe, double lean) {
  const std::size_t count = (static_cast<std::size_t>(lobes) + 1) * points_per_lobe;
  constexpr double far_below = -30;
  ManifoldPair pair{{{-0.5, far_below}}, {}};
  for (std::size_t k = 0; k <= count; ++k) {
    const double x = -0.5 + static_cast<double>(k) / static_cast<double>(points_per_lobe);
    const double y = std::sin(std::numbers::pi * x);
    pair.u.push_back({x, y});
    pair.s.push_back({x + lean * y * y, -y});
  }
  pair.s.push_back({pair.s.back().x, far_below});
  pair.s = {pair.s.rbegin(), pair.s.rend()};
  return pair;
}

/// A wave from the left over a flat arc from the right, whose chord between p+ and p- crosses the wave three times; of
/// `segments` on the arc and four times as many on the wave.
inline ManifoldPair wave_and_arc(std::size_t segments) {
  ManifoldPair pair;
  for (std::size_t k = 0; k <= 4 * segments; ++k) {
    const double x = static_cast<double>(k) / static_cast<double>(4 * segments);
    pair.u.push_back({x, 0.3 * std::sin(5 * std::numbers::pi * x)});
  }
  for (std::size_t k = 0; k <= segments; ++k) {
    const double t = 1 - static_cast<double>(k) / static_cast<double>(segments);
    pair.s.push_back({1.05 * t, -0.05 * std::sin(std::numbers::pi * t)});
  }
  return pair;
}

}  // namespace lober::detail
