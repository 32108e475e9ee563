#include <algorithm>
#include <cmath>

#include "kernels/elementary.hpp"
#include "lober/curve/drawing.hpp"

namespace lober {
using namespace detail;
namespace {

// The directions that the points since the last kept one allow.
class Cone {
 public:
  explicit Cone(Point apex) : apex_(apex) {}

  // Whether a line from the apex to this point is close enough to all points before; if so, narrows the cone.
  bool take(Point point, double tolerance) {
    const double x = point.x - apex_.x, y = point.y - apex_.y, distance = std::hypot(x, y);
    if (distance + tolerance < reach_) return false;  // it has turned back
    if (reach_ == 0 && distance <= tolerance) return true;
    const double half_width = elementary::asin(std::min(1.0, tolerance / distance));
    if (reach_ == 0) {
      axis_ = {x, y};
      low_ = -half_width;
      high_ = half_width;
    } else {
      const double angle = elementary::atan2(axis_.x * y - axis_.y * x, axis_.x * x + axis_.y * y);
      if (angle < low_ || angle > high_) return false;
      low_ = std::max(low_, angle - half_width);
      high_ = std::min(high_, angle + half_width);
    }
    reach_ = std::max(reach_, distance);
    return true;
  }

 private:
  Point apex_;
  Point axis_{1, 0};
  double low_ = 0, high_ = 0;  // angles against the axis
  double reach_ = 0;           // distance of the farthest point; 0 while all are close to the apex
};

}  // namespace

std::vector<Point> simplified_line(std::span<const Point> line, double tolerance) {
  std::vector<Point> kept;
  if (line.empty()) return kept;
  kept.push_back(line[0]);
  Cone cone(line[0]);
  for (std::size_t k = 1; k < line.size(); ++k) {
    if (cone.take(line[k], tolerance)) continue;
    kept.push_back(line[k - 1]);
    cone = Cone(line[k - 1]);
    cone.take(line[k], tolerance);
  }
  if (line.size() > 1) kept.push_back(line.back());
  return kept;
}

}  // namespace lober
