// The crossings of a ray from one point to the right, counted part by part (private to index/).
//
// Heights are half-open, a vertex at the height of the point counts as below it, so that every crossing belongs to
// exactly one segment.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "engine/geometry/index/ray_crossings.hpp"
#include "kernels/predicates.hpp"
#include "kernels/ray.hpp"

namespace lober::detail {

class RayTally {
 public:
  explicit RayTally(Point point, std::int32_t number = 0) : point_(point), found_{number, false} {}

  [[nodiscard]] const RayCrossings& found() const { return found_; }
  void add(std::int32_t number) { found_.number += number; }
  /// A part of the curve that lies wholly to the right of the point, from one height to another.
  void add_ahead(double from, double to) {
    found_.number += static_cast<int>(to > point_.y) - static_cast<int>(from > point_.y);
  }
  /// The segments between the leaf_size + 1 points of a leaf.
  void add_leaf(const Point* p) {
    const HeightCrossings found = crossings_of_height(p, point_);
    found_.number += found.number;
    for (std::uint64_t bits = found.up | found.down; bits != 0; bits &= bits - 1) {
      const auto segment = static_cast<std::size_t>(std::countr_zero(bits)) / 2;
      const int direction = (found.up & bits & -bits) != 0 ? 1 : -1;
      const int side = orient2d(p[segment], p[segment + 1], point_, counts_);
      if (side == 0) found_.on = true;
      if (side == direction) found_.number += direction;  // the crossing is to the right of the point
    }
    for (std::uint64_t bits = found.level; bits != 0; bits &= bits - 1) {
      const auto segment = static_cast<std::size_t>(std::countr_zero(bits)) / 2;
      const Point a = p[segment], b = p[segment + 1];
      found_.on = found_.on || a == point_ || b == point_ || (a.y == b.y && (a.x < point_.x) != (b.x < point_.x));
    }
  }

 private:
  Point point_;
  RayCrossings found_;
  PredicateCounts counts_;
};

}  // namespace lober::detail
