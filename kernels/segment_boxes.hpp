// Boxes of the segments of two leaves, and which of them meet.
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernels/box.hpp"
#include "kernels/leaf.hpp"
#include "lober/overlay/segment_pair.hpp"

namespace lober::detail {

/// low <= normal . p <= high.
struct Slab {
  Point normal;
  double low, high;
};

/// Boxes of the leaf_size segments of a leaf, by coordinate, so that four are compared at once, the same of each
/// group of four segments, and a slab that holds the leaf.
struct alignas(64) SegmentBoxes {
  static constexpr std::size_t groups = leaf_size / 4;
  double min_x[leaf_size];
  double max_x[leaf_size];
  double min_y[leaf_size];
  double max_y[leaf_size];
  double group_min_x[groups];
  double group_max_x[groups];
  double group_min_y[groups];
  double group_max_y[groups];
  /// Holds all points of the leaf. Where folds run side by side and slanted their boxes overlap, but not their slabs.
  Slab slab;
};

/// Bits of all segments of a leaf.
inline constexpr std::uint32_t all_segments = ~std::uint32_t{0};
static_assert(leaf_size == 32);

/// Fills `boxes` from the leaf_size + 1 points of a leaf.
void segment_boxes(const Point* points, SegmentBoxes& boxes);

/// Writes to `pairs` the (a_begin + i, b_begin + j), bit j of `wanted` set, such that the boxes of segment i of leaf a
/// and segment j of leaf b meet (touching counts; decided exactly), segment j does not lie wholly on one side of the
/// slab of leaf a, and has a length; every pair of segments with a common point is among them, but for segments j of no
/// length, which carry nothing. Ordered by j, then i. Returns how many; room for leaf_size^2 is needed. `b_box` is the
/// box of leaf b. Coordinates must be finite.
std::size_t meeting_segments(const SegmentBoxes& a, std::uint32_t a_begin, const Point* b, const Box& b_box,
                             std::uint32_t b_begin, SegmentPair* pairs, std::uint32_t wanted = all_segments);

}  // namespace lober::detail
