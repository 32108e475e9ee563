// What the kernels compute with points.
#pragma once

#include <cmath>

#include "kernels/inline.hpp"
#include "lober/point.hpp"

namespace lober {

/// Rounded; squares may overflow beyond 1e154.
[[nodiscard]] LOBER_INLINE double distance(Point a, Point b) {
  const double x = b.x - a.x, y = b.y - a.y;
  return std::sqrt(x * x + y * y);
}

}  // namespace lober
