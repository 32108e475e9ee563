// How far areas are from reference values.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "bench/scenes/scenes.hpp"

namespace lober::bench {

/// Area of the box around both curves.
inline double box_area(const Scene& scene) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Point low{infinity, infinity};
  Point high{-infinity, -infinity};
  for (const Polygon* polygon : {&scene.first, &scene.second}) {
    for (const Point& point : *polygon) {
      low = {std::min(low.x, point.x), std::min(low.y, point.y)};
      high = {std::max(high.x, point.x), std::max(high.y, point.y)};
    }
  }
  return (high.x - low.x) * (high.y - low.y);
}

/// The largest error relative to the reference, of those of the four areas that exceed 1e-12 of the box
/// around both curves; an area below must stay below, else its error relative to that limit counts.
inline double area_error(const std::array<double, 4>& areas, const std::array<double, 4>& reference,
                         const Scene& scene) {
  const double least = 1e-12 * box_area(scene);
  double largest = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const double error = std::fabs(areas[k] - reference[k]);
    if (reference[k] > least) {
      largest = std::max(largest, error / reference[k]);
    } else if (!(std::fabs(areas[k]) <= least)) {
      largest = std::max(largest, error / least);
    }
  }
  return largest;
}

}  // namespace lober::bench
