// Curves with known areas, and points on them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "lober/curve/point.hpp"
#include "lober/overlay/areas.hpp"

namespace lober::smooth_test {

using std::numbers::pi;
using Points = std::vector<Point>;
using Shape = std::function<Point(double)>;

inline constexpr std::array members{
    &Areas::c1,          &Areas::c2,          &Areas::intersection,        &Areas::union_,
    &Areas::c1_minus_c2, &Areas::c2_minus_c1, &Areas::symmetric_difference};

inline Points sample(const Shape& shape, int n, double phase = 0.137) {
  Points points(static_cast<std::size_t>(n));
  for (int k = 0; k < n; ++k) points[static_cast<std::size_t>(k)] = shape(2 * pi * (k + phase) / n);
  return points;
}
inline Shape ellipse(double x, double y, double a, double b) {
  return [=](double t) { return Point{x + a * std::cos(t), y + b * std::sin(t)}; };
}
inline Shape wavy(double a, int k) {
  return [=](double t) {
    const double r = 1 + a * std::sin(k * t);
    return Point{r * std::cos(t), r * std::sin(t)};
  };
}

inline Areas from(double c1, double c2, double common) {
  return {c1, c2, common, c1 + c2 - common, c1 - common, c2 - common, c1 + c2 - 2 * common};
}

// Two unit circles, centres `apart`.
inline Areas lens(double apart) {
  return from(pi, pi, 2 * std::acos(apart / 2) - apart / 2 * std::sqrt(4 - apart * apart));
}
// x^2 / a^2 + y^2 = 1 and the same turned by 90 degrees: four times (1/2) int r^2 over |angle| < pi / 4 of the one
// whose radius is less there.
inline Areas crossed_ellipses(double a) {
  return from(pi * a, pi * a, 4 * a * std::atan(1 / a));
}
// r = 1 + a sin k theta and the unit circle; inside both, r = 1 on half of the angles and less on the other half.
inline Areas waves(double a) {
  return from(pi * (1 + a * a / 2), pi, pi / 2 + (pi / 2 - 2 * a + pi * a * a / 4));
}

inline Points jittered(Points points, double size, unsigned seed) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> normal(0, size);
  for (Point& p : points) {
    p.x += normal(engine);
    p.y += normal(engine);
  }
  return points;
}

inline double worst(const Areas& areas, const Areas& exact) {
  double error = 0;
  for (const auto member : members) error = std::max(error, std::fabs(areas.*member / (exact.*member) - 1));
  return error;
}

struct Scene {
  const char* name;
  Shape c1, c2;
  Areas exact;
};
inline std::vector<Scene> scenes() {
  return {{"lens", ellipse(0, 0, 1, 1), ellipse(0.7, 0, 1, 1), lens(0.7)},
          {"ellipses", ellipse(0, 0, 1.8, 1), ellipse(0, 0, 1, 1.8), crossed_ellipses(1.8)},
          {"waves", wavy(0.1, 5), ellipse(0, 0, 1, 1), waves(0.1)}};
}

}  // namespace lober::smooth_test
