// Axis-parallel boxes, laid out so that one vector compare decides whether two of them meet.
#pragma once

#include <algorithm>
#include <limits>

#include "kernels/point.hpp"

namespace lober {

/// Closed box, stored as (min x, min y, -max x, -max y): uniting boxes is a minimum in all four lanes, and two boxes
/// a, b meet iff a.lane[k] <= -b.lane[k ^ 2] for every k. Negation is exact, so are all decisions.
struct alignas(32) Box {
  double lane[4] = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
                    std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};

  static Box of(Point a, Point b) {
    return {{std::min(a.x, b.x), std::min(a.y, b.y), -std::max(a.x, b.x), -std::max(a.y, b.y)}};
  }
  [[nodiscard]] double min_x() const { return lane[0]; }
  [[nodiscard]] double min_y() const { return lane[1]; }
  [[nodiscard]] double max_x() const { return -lane[2]; }
  [[nodiscard]] double max_y() const { return -lane[3]; }
  [[nodiscard]] double width() const { return max_x() - min_x(); }
  [[nodiscard]] double height() const { return max_y() - min_y(); }
  /// Half the perimeter: the measure of size that never vanishes for a segment.
  [[nodiscard]] double extent() const { return width() + height(); }
};

inline Box unite(const Box& a, const Box& b) {
  return {{std::min(a.lane[0], b.lane[0]), std::min(a.lane[1], b.lane[1]), std::min(a.lane[2], b.lane[2]),
           std::min(a.lane[3], b.lane[3])}};
}

inline bool meet(const Box& a, const Box& b) {
  return a.lane[0] <= -b.lane[2] && a.lane[1] <= -b.lane[3] && a.lane[2] <= -b.lane[0] && a.lane[3] <= -b.lane[1];
}

/// Whether `point` lies in the closed box.
inline bool contains(const Box& box, Point point) {
  return box.lane[0] <= point.x && box.lane[1] <= point.y && box.lane[2] <= -point.x && box.lane[3] <= -point.y;
}

}  // namespace lober
