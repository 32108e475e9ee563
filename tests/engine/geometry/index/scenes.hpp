// Pairs of curves on which searches may go wrong. They need not be simple: a search knows nothing of that.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <ostream>
#include <vector>

#include "lober/curve/curve.hpp"
#include "tests/kernels/random_doubles.hpp"

namespace lober::test {

struct Scene {
  Curve first, second;
};

/// Makes a pair of curves with about `size` vertices each.
struct SceneKind {
  const char* name;
  Scene (*make)(Random& random, std::size_t size);
  std::size_t largest;  ///< beyond which brute force takes too long
  /// Enough for several tasks where the scene has not too many pairs.
  [[nodiscard]] std::size_t size_for_threads() const { return largest < 3000 ? largest : 40000; }
};
inline std::ostream& operator<<(std::ostream& stream, const SceneKind& kind) {
  return stream << kind.name;
}

namespace scene {

inline Curve circle(std::size_t size, Point centre, double radius) {
  Curve curve;
  for (std::size_t k = 0; k < size; ++k) {
    const double t = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(size);
    curve.points.push_back({centre.x + radius * std::cos(t), centre.y + radius * std::sin(t)});
  }
  return curve;
}

/// Diagonal needles side by side.
inline Curve needles(std::size_t size, double angle, Point centre) {
  Curve curve;
  for (std::size_t k = 0; k < size; ++k) {
    const double x = static_cast<double>(k) / static_cast<double>(size) - 0.5, y = k % 2 == 0 ? -0.5 : 0.5;
    curve.points.push_back(
        {centre.x + x * std::cos(angle) - y * std::sin(angle), centre.y + x * std::sin(angle) + y * std::cos(angle)});
  }
  return curve;
}

template <typename Move>
Curve moved(Curve curve, const Move& move) {
  for (Point& point : curve.points) point = move(point);
  return curve;
}

inline Scene circles(Random& random, std::size_t size) {
  return {circle(size, {0, 0}, 1), circle(size + random.index(3), {random.uniform(-2, 2), random.uniform(-1, 1)}, 1)};
}
inline Scene close_circles(Random& random, std::size_t size) {
  return {circle(size, {0, 0}, 1), circle(size, {random.log_uniform(1e-9, 1e-2), 0}, 1)};
}
inline Scene scattered(Random& random, std::size_t size) {
  Scene result;
  for (Curve* curve : {&result.first, &result.second}) {
    for (std::size_t k = 0; k < size; ++k) curve->points.push_back({random.unit(), random.unit()});
  }
  return result;
}
inline Scene walks(Random& random, std::size_t size) {
  Scene result;
  for (Curve* curve : {&result.first, &result.second}) {
    Point at{random.uniform(0, 10), random.uniform(0, 10)};
    for (std::size_t k = 0; k < size; ++k) {
      curve->points.push_back(at = {at.x + random.uniform(-1, 1), at.y + random.uniform(-1, 1)});
    }
  }
  return result;
}
/// Touching boxes, vertices on segments, overlaps, repeated vertices, cell borders hit exactly.
inline Scene lattice_walks(Random& random, std::size_t size) {
  Scene result;
  for (Curve* curve : {&result.first, &result.second}) {
    Point at{static_cast<double>(random.integer(0, 8)), static_cast<double>(random.integer(0, 8))};
    for (std::size_t k = 0; k < size; ++k) {
      curve->points.push_back(at = {at.x + random.integer(-1, 1), at.y + random.integer(-1, 1)});
    }
  }
  return result;
}
/// Spacing from 1 down to 1e-12 and back.
inline Scene geometric(Random& random, std::size_t size) {
  Scene result;
  const std::size_t half = size / 2 + 2;
  for (Curve* curve : {&result.first, &result.second}) {
    const double shift = random.uniform(0, 0.1);
    for (std::size_t k = 0; k < 2 * half; ++k) {
      const std::size_t depth = k < half ? k : 2 * half - 1 - k;
      const double x = std::pow(1e-12, static_cast<double>(depth) / static_cast<double>(half));
      curve->points.push_back({x * (1 + shift), (k < half ? x : -x) * random.uniform(0.5, 1.5)});
    }
  }
  return result;
}
inline Scene shared_arc(Random& random, std::size_t size) {
  Scene result{circle(size, {0, 0}, 1), circle(size, {0, 0}, 1)};
  for (std::size_t k = 0; k < size / 2; ++k) result.second.points[k].x += random.log_uniform(1e-12, 1e-1);
  if (random.chance(0.5)) std::reverse(result.second.points.begin(), result.second.points.end());
  return result;
}
inline Scene identical(Random& random, std::size_t size) {
  Scene result = walks(random, size);
  result.second = result.first;
  return result;
}
inline Scene combs(Random& random, std::size_t size) {
  return {needles(size, 0.8, {0, 0}), needles(size, random.uniform(0, 3), {random.unit(), random.unit()})};
}
inline Scene comb_and_circle(Random& random, std::size_t size) {
  return {needles(size, 0.8, {0, 0}), circle(size, {random.unit(), random.unit()}, 0.6)};
}
inline Scene repeated_vertices(Random& random, std::size_t size) {
  Scene result = walks(random, size);
  for (Curve* curve : {&result.first, &result.second}) {
    for (std::size_t k = 1; k < curve->points.size(); ++k) {
      if (random.chance(0.5)) curve->points[k] = curve->points[k - 1];
    }
  }
  return result;
}
/// Curves that stay in one point for hundreds of vertices, some of them both in the same one.
inline Scene stalls(Random& random, std::size_t size) {
  Scene result = walks(random, size);
  const Point both = result.first.points[0];
  for (Curve* curve : {&result.first, &result.second}) {
    std::vector<Point>& points = curve->points;
    for (std::size_t k = 0; k < size;) {
      const std::size_t end = std::min<std::size_t>(size, k + 1 + random.index(random.chance(0.5) ? 400 : 20));
      const Point at = random.chance(0.3) ? both : points[k];
      const bool stays = random.chance(0.5);
      for (; k < end; ++k) {
        if (stays) points[k] = at;
      }
    }
  }
  return result;
}
inline Scene lengths_of_all_sizes(Random& random, std::size_t size) {
  Scene result;
  for (Curve* curve : {&result.first, &result.second}) {
    Point at{0, 0};
    for (std::size_t k = 0; k < size; ++k) {
      const double step = random.log_uniform(1e-14, 10);
      curve->points.push_back(at = {at.x + random.uniform(-step, step), at.y + random.uniform(-step, step)});
    }
  }
  return result;
}
inline Scene far_from_origin(Random& random, std::size_t size) {
  const auto move = [](Point p) { return Point{1e8 + p.x * 1e-3, -3e9 + p.y * 1e-3}; };
  const Scene result = walks(random, size);
  return {moved(result.first, move), moved(result.second, move)};
}
inline Scene huge(Random& random, std::size_t size) {
  const Scene result = walks(random, size);
  const auto move = [&](Point p) { return Point{p.x * 1e300, p.y * 1e300}; };
  return {moved(result.first, move), moved(result.second, move)};
}
inline Scene close_to_overflow(Random& random, std::size_t size) {
  const Scene result = scattered(random, size);
  const auto move = [&](Point p) { return Point{(2 * p.x - 1) * 1.7e308, (2 * p.y - 1) * 1.7e308}; };
  return {moved(result.first, move), moved(result.second, move)};
}
inline Scene tiny(Random& random, std::size_t size) {
  const Scene result = walks(random, size);
  const double scale = random.chance(0.5) ? 1e-300 : 1e-321;  // normal and denormal
  const auto move = [&](Point p) { return Point{p.x * scale, p.y * scale}; };
  return {moved(result.first, move), moved(result.second, move)};
}
/// Few segments reach from a small region to the end of the world.
inline Scene long_arms(Random& random, std::size_t size) {
  Scene result = walks(random, size);
  for (Curve* curve : {&result.first, &result.second}) {
    for (int k = 0; k < 5; ++k) {
      const double far = random.log_uniform(1e2, 1e305);
      curve->points[random.index(curve->points.size())] = {random.uniform(-far, far), random.uniform(-far, far)};
    }
  }
  return result;
}
/// Only a line, or a point, is common to both boxes.
inline Scene boxes_that_touch(Random& random, std::size_t size) {
  Scene result = lattice_walks(random, size);
  const bool corner = random.chance(0.5);
  result.first = moved(result.first, [&](Point p) {
    return Point{std::min(p.x, 4.0), corner ? std::min(p.y, 4.0) : p.y};
  });
  result.second = moved(result.second, [&](Point p) {
    return Point{std::max(p.x, 4.0), corner ? std::max(p.y, 4.0) : p.y};
  });
  return result;
}
inline Scene on_one_line(Random& random, std::size_t size) {
  Scene result = walks(random, size);
  const auto move = [](Point p) { return Point{p.x, 3}; };
  return {moved(result.first, move), moved(result.second, move)};
}
inline Scene apart(Random& random, std::size_t size) {
  Scene result = walks(random, size);
  result.second = moved(result.second, [](Point p) { return Point{p.x + 1e6, p.y}; });
  return result;
}
inline Scene open_curves(Random& random, std::size_t size) {
  Scene result = walks(random, size);
  result.first.closed = result.second.closed = false;
  return result;
}

}  // namespace scene

inline const std::vector<SceneKind>& scene_kinds() {
  static const std::vector<SceneKind> kinds = {
      {"circles", scene::circles, 10000},
      {"close_circles", scene::close_circles, 3000},
      {"scattered", scene::scattered, 150},
      {"walks", scene::walks, 3000},
      {"lattice_walks", scene::lattice_walks, 300},
      {"geometric", scene::geometric, 2100},
      {"shared_arc", scene::shared_arc, 3000},
      {"identical", scene::identical, 3000},
      {"combs", scene::combs, 150},
      {"comb_and_circle", scene::comb_and_circle, 300},
      {"repeated_vertices", scene::repeated_vertices, 3000},
      {"stalls", scene::stalls, 3000},
      {"lengths_of_all_sizes", scene::lengths_of_all_sizes, 300},
      {"far_from_origin", scene::far_from_origin, 3000},
      {"huge", scene::huge, 300},
      {"close_to_overflow", scene::close_to_overflow, 100},
      {"tiny", scene::tiny, 300},
      {"long_arms", scene::long_arms, 300},
      {"boxes_that_touch", scene::boxes_that_touch, 300},
      {"on_one_line", scene::on_one_line, 150},
      {"apart", scene::apart, 10000},
      {"open_curves", scene::open_curves, 3000},
  };
  return kinds;
}

}  // namespace lober::test
