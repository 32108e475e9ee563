#pragma once

#include <algorithm>
#include <cmath>

#include "lober/curve/point.hpp"

namespace lober {

[[nodiscard]] inline double distance_to_segment(Point p, Point a, Point b) {
  const double x = b.x - a.x, y = b.y - a.y, square = x * x + y * y;
  double t = square > 0 ? ((p.x - a.x) * x + (p.y - a.y) * y) / square : 0;
  t = std::clamp(t, 0.0, 1.0);
  return std::hypot(p.x - a.x - t * x, p.y - a.y - t * y);
}

}  // namespace lober
