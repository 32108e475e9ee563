// A slab round a leaf that bends with it: what tells the leaves of folds apart that run side by side and turn.
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernels/leaf.hpp"
#include "kernels/point.hpp"

namespace lober::detail {

/// low <= v - bend u^2 <= high and left <= u <= right, where u and v are measured from `middle` along `along` and to
/// the left of it, both times its length.
struct BentSlab {
  Point middle;
  Point along;
  double bend;
  double low, high;
  double left, right;
};

/// Fills `slab` with one that holds the segments between the leaf_size + 1 points of a leaf, whatever rounding does:
/// along the parabola through its ends and its middle, or straight where that is narrower. All of the plane, where
/// numbers overflow.
void bent_slab(const Point* points, BentSlab& slab);

/// Bit j is set unless segment j of the leaf lies wholly on one side of the slab, or beyond one of its ends.
[[nodiscard]] std::uint32_t segments_meeting(const BentSlab& slab, const Point* points);

}  // namespace lober::detail
