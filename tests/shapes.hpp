// Simple closed polygons that many tests use.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "lober/curve/point.hpp"

namespace lober::test {

using Points = std::vector<Point>;

/// A rectangle with sides along the axes.
[[nodiscard]] inline Points box(double left, double low, double right, double high) {
  return {{left, low}, {right, low}, {right, high}, {left, high}};
}

/// r = radius (1 + height sin(waves angle)) about `centre`, from the angle `turn` on.
[[nodiscard]] inline Points wavy_circle(std::size_t count, double height, int waves, double turn = 0,
                                        Point centre = {0, 0}, double radius = 1) {
  Points points(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double angle = turn + 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(count);
    const double r = radius * (1 + height * std::sin(waves * angle));
    points[k] = {centre.x + r * std::cos(angle), centre.y + r * std::sin(angle)};
  }
  return points;
}

/// From the angle `turn` on.
[[nodiscard]] inline Points circle(std::size_t count, Point centre, double radius, double turn = 0) {
  return wavy_circle(count, 0, 0, turn, centre, radius);
}

[[nodiscard]] inline Points reversed(Points points) {
  std::reverse(points.begin(), points.end());
  return points;
}

}  // namespace lober::test
