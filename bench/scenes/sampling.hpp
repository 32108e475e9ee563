// Points on a closed curve that is folded by a map: more where it turns.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "bench/scenes/shapes.hpp"
#include "kernels/box.hpp"

namespace lober::bench {

using Turns = std::vector<double>;  // parameters on the initial circle, ascending from 0, all below 1

inline Turns equal_turns(std::size_t count) {
  Turns turns(count);
  for (std::size_t k = 0; k < count; ++k) turns[k] = static_cast<double>(k) / static_cast<double>(count);
  return turns;
}

inline double turning(Point a, Point b, Point c) {
  const Point u{b.x - a.x, b.y - a.y};
  const Point v{c.x - b.x, c.y - b.y};
  return std::fabs(std::atan2(u.x * v.y - u.y * v.x, u.x * v.x + u.y * v.y));
}

struct Sampling {
  Turns turns;
  double length = 0;  ///< of the polygon that was measured to find them
};

// `count` parameters spread so that steps are short (a third of the weight), turn little (the ends of the
// folds need points as well as the long folds do), and stay close to the smooth curve (neighbouring folds
// must not be cut), measured on the polygon of `turns`.
template <typename Curve>
Sampling spread(const Curve& curve, const Turns& turns, std::size_t count) {
  const std::size_t size = turns.size();
  Polygon image(size);
  for (std::size_t k = 0; k < size; ++k) image[k] = curve(turns[k]);
  std::vector<double> lengths(size);
  std::vector<double> turnings(size);
  std::vector<double> sagittas(size);  // their square roots, which shrink in proportion to the steps
  double length = 0;
  double turned = 0;
  double sagitta = 0;
  for (std::size_t k = 0; k < size; ++k) {
    const Point a = image[k];
    const Point b = image[(k + 1) % size];
    lengths[k] = distance(a, b);
    turnings[k] = (turning(image[(k + size - 1) % size], a, b) + turning(a, b, image[(k + 2) % size])) / 2;
    sagittas[k] = std::sqrt(lengths[k] * turnings[k]);
    length += lengths[k];
    turned += turnings[k];
    sagitta += sagittas[k];
  }
  Sampling result{Turns(count), length};
  double before = 0;
  std::size_t next = 0;
  for (std::size_t k = 0; k < size; ++k) {
    const double share = (lengths[k] / length + turnings[k] / turned + sagittas[k] / sagitta) / 3;
    const double end = k + 1 == size ? 1 : turns[k + 1];
    for (; next < count; ++next) {
      const double wanted = static_cast<double>(next) / static_cast<double>(count);
      if (wanted >= before + share && k + 1 != size) break;
      result.turns[next] = turns[k] + std::min((wanted - before) / share, 1.0) * (end - turns[k]);
    }
    before += share;
  }
  return result;
}

/// A polygon of `points` vertices on the curve, which `curve(turn)` gives for turn in [0, 1).
template <typename Curve>
Polygon sampled(const Curve& curve, std::size_t points) {
  const std::size_t coarse = std::max(points / 8, std::min<std::size_t>(points, 100000));
  Turns turns = equal_turns(coarse);
  for (int pass = 0; pass < 2; ++pass) turns = spread(curve, turns, coarse).turns;
  turns = spread(curve, turns, points).turns;
  Polygon polygon(points);
  for (std::size_t k = 0; k < points; ++k) polygon[k] = curve(turns[k]);
  return polygon;
}

}  // namespace lober::bench
