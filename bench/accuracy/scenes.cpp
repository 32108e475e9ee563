#include <algorithm>
#include <cmath>
#include <span>

#include "bench/accuracy/accuracy.hpp"
#include "bench/scenes/shapes.hpp"

namespace lober::bench {
namespace {

// Two equal ellipses with half axes a > b, one of them turned by a quarter: C1 \ C2 are two lobes. In polar coordinates
// the curves are r = a b / sqrt(b^2 cos^2 + a^2 sin^2) and the same with sine and cosine exchanged, equal at 45
// degrees, and the overlap is 4 a b atan(b / a).
Scene make_ellipses(std::size_t points) {
  constexpr double a = 1.3, b = 0.7;
  const auto ellipse = [&](double width, double height, double phase) {
    Polygon polygon(points);
    for (std::size_t k = 0; k < points; ++k) {
      const double angle = full_turn * ((static_cast<double>(k) + phase) / static_cast<double>(points));
      polygon[k] = {width * std::cos(angle), height * std::sin(angle)};
    }
    return polygon;
  };
  const double area = std::numbers::pi * a * b;
  return {ellipse(a, b, 0.13), ellipse(b, a, 0.57), areas_from_overlap(area, area, 4 * a * b * std::atan(b / a)), 4};
}

constexpr AccuracyScene scene_list[] = {
    {"lens", "two unit circles", make_lens},
    {"ellipses", "two ellipses across each other", make_ellipses},
    {"wavy", "unit circle against r = 1 + 0.1 sin 8 theta", make_wavy16},
    {"henon", "turnstile lobe of the Henon map, k = 0", make_henon_lobe},
};

}  // namespace

std::span<const AccuracyScene> accuracy_scenes() {
  return scene_list;
}

}  // namespace lober::bench
