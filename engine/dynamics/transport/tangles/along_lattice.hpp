// Positions in a plane that repeats itself: along the lattice and across it (private to transport/).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "kernels/point.hpp"

namespace lober::detail {

/// Positions of points along a lattice, and above the line along it through the origin.
class AlongLattice {
 public:
  explicit AlongLattice(Point lattice) : lattice_(lattice), period_(length(lattice)) {}
  [[nodiscard]] Point operator()(Point plane) const {
    return {(lattice_.x * plane.x + lattice_.y * plane.y) / period_,
            (lattice_.x * plane.y - lattice_.y * plane.x) / period_};
  }
  [[nodiscard]] double period() const { return period_; }

 private:
  Point lattice_;
  double period_;
};
/// The position of one point.
[[nodiscard]] inline Point along_and_above(Point lattice, Point plane) {
  return AlongLattice(lattice)(plane);
}

/// The reach of points along the lattice, in units of it.
struct Reach {
  double from = 0, to = 0;
};
/// The reach of one point or more.
[[nodiscard]] inline Reach reach_of(std::span<const Point> points, Point lattice) {
  const AlongLattice along(lattice);
  Reach reach{along(points.front()).x / along.period(), 0};
  reach.to = reach.from;
  for (const Point point : points) {
    const double at = along(point).x / along.period();
    reach.from = std::min(reach.from, at);
    reach.to = std::max(reach.to, at);
  }
  return reach;
}

/// Translates to one side that two curves may meet.
[[nodiscard]] inline std::size_t translates_in_reach(std::span<const Point> u, std::span<const Point> s,
                                                     Point lattice) {
  const Reach of_u = reach_of(u, lattice), of_s = reach_of(s, lattice);
  return static_cast<std::size_t>(std::floor(std::max(of_u.to, of_s.to) - std::min(of_u.from, of_s.from)));
}

/// Points of the copy that lies `times` periods along the lattice.
[[nodiscard]] inline Point moved(Point point, Point lattice, int times) {
  return {point.x + times * lattice.x, point.y + times * lattice.y};
}

}  // namespace lober::detail
