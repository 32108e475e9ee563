#include "kernels/interpolation.hpp"
#include "kernels/elementary.hpp"

#include <cmath>
#include <limits>

namespace lober::detail {

double curvature(Point a, Point b, Point c) {
  const Point e = b - a, f = c - b, g = c - a;
  const double denominator = std::sqrt(dot(e, e) * dot(f, f)) * std::sqrt(dot(g, g));
  constexpr double largest = std::numeric_limits<double>::max();
  return denominator > 0 && denominator <= largest ? 2 * cross(e, f) / denominator : 0;
}

double turning_angle(Point a, Point b, Point c) {
  const Point e = b - a, f = c - b;
  return elementary::atan2(std::fabs(cross(e, f)), dot(e, f));
}

double turning_angle_bound(Point a, Point b, Point c) {
  const Point e = b - a, f = c - b;
  const double sine = std::fabs(cross(e, f)), cosine = dot(e, f);
  if (sine == 0 && cosine >= 0) return 0;
  return cosine > 0 ? sine / cosine : std::numeric_limits<double>::infinity();
}

}  // namespace lober::detail
