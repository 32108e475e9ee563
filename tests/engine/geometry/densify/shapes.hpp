// Curves that the tests of densify/ share, and a brute-force judge.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

#include "kernels/box.hpp"
#include "lober/curve/densify.hpp"

namespace lober::densify_test {
using namespace lober::detail;

inline Point ellipse_at(double angle) {
  return {3 + 2 * std::cos(angle), -1 + std::sin(angle)};
}

/// Vertices of the ellipse at equal or, with `uneven`, smoothly varying steps; `turn` of 2 pi is the whole of it.
inline std::vector<Point> ellipse(std::size_t count, double uneven = 0, double turn = 2 * std::numbers::pi,
                                  bool closed = true) {
  std::vector<Point> points;
  for (std::size_t k = 0; k < count; ++k) {
    const double s = static_cast<double>(k) / static_cast<double>(closed ? count : count - 1);
    points.push_back(ellipse_at(turn * s + uneven * std::sin(2 * std::numbers::pi * s)));
  }
  return points;
}

/// How far the point is from the ellipse, to first order.
inline double off_ellipse(Point p) {
  const double x = (p.x - 3) / 2, y = p.y + 1;
  const double gx = x / 2, gy = y;
  return std::fabs((x * x + y * y - 1) / (2 * std::hypot(gx, gy)));
}

inline double angle_at(Point a, Point b, Point c) {
  const double e = std::atan2(b.y - a.y, b.x - a.x), f = std::atan2(c.y - b.y, c.x - b.x);
  return std::fabs(std::remainder(f - e, 2 * std::numbers::pi));
}

struct Extremes {
  double max_length = 0, angle = 0, distance_angle = 0, min_length = Criteria::off;
};

/// Every segment and every angle, looked at one by one.
inline Extremes extremes(CurveView curve) {
  Extremes found;
  const std::size_t size = curve.points.size();
  for (std::size_t k = 0; k < curve.segments(); ++k) {
    const auto [a, b] = curve.segment(k);
    const double length = distance(a, b);
    found.max_length = std::max(found.max_length, length);
    found.min_length = std::min(found.min_length, length);
    if (curve.closed || k + 1 < curve.segments()) {
      const Point c = curve.points[(k + 2) % size];
      const double angle = angle_at(a, b, c);
      found.angle = std::max(found.angle, angle);
      found.distance_angle = std::max(found.distance_angle, angle * std::max(length, distance(b, c)));
    }
  }
  return found;
}

/// Whether the points of `given` occur in `result` in order, the first and (open) the last in their places.
inline bool keeps(std::span<const Point> given, std::span<const Point> result) {
  std::size_t next = 0;
  for (const Point& point : result) next += next < given.size() && point == given[next] ? 1 : 0;
  return next == given.size() && result.front() == given.front();
}

}  // namespace lober::densify_test
