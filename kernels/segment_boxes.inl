// Body of segment_boxes and meeting_segments (kernels/all.inl).
#pragma once

#include <algorithm>
#include <cmath>

#include "kernels/segment_boxes.hpp"
#include "kernels/simd.hpp"

namespace lober::detail {
namespace {

inline void boxes_of(const Point* points, SegmentBoxes& boxes) {
  const double* coordinates = &points[0].x;
  for (std::size_t i = 0; i < leaf_size; i += lanes) {
    const Lanes begin0 = load(coordinates + 2 * i), begin1 = load(coordinates + 2 * i + 4);
    const Lanes end0 = load(coordinates + 2 * i + 2), end1 = load(coordinates + 2 * i + 6);
    const Lanes low0 = min(begin0, end0), low1 = min(begin1, end1);
    const Lanes high0 = max(begin0, end0), high1 = max(begin1, end1);
    store(boxes.min_x + i, __builtin_shufflevector(low0, low1, 0, 2, 4, 6));
    store(boxes.min_y + i, __builtin_shufflevector(low0, low1, 1, 3, 5, 7));
    store(boxes.max_x + i, __builtin_shufflevector(high0, high1, 0, 2, 4, 6));
    store(boxes.max_y + i, __builtin_shufflevector(high0, high1, 1, 3, 5, 7));
  }
}

// Least (or greatest) of each group of four.
template <typename Pick>
inline void by_groups(const double* values, double* result, const Pick& pick) {
  for (std::size_t group = 0; group < SegmentBoxes::groups; group += lanes) {
    Lanes rows[lanes];
    for (std::size_t k = 0; k < lanes; ++k) rows[k] = load(values + (group + k) * lanes);
    transpose(rows);
    store(result + group, pick(pick(rows[0], rows[1]), pick(rows[2], rows[3])));
  }
}

inline void group_boxes(SegmentBoxes& boxes) {
  const auto lower = [](Lanes a, Lanes b) { return min(a, b); };
  const auto upper = [](Lanes a, Lanes b) { return max(a, b); };
  by_groups(boxes.min_x, boxes.group_min_x, lower);
  by_groups(boxes.min_y, boxes.group_min_y, lower);
  by_groups(boxes.max_x, boxes.group_max_x, upper);
  by_groups(boxes.max_y, boxes.group_max_y, upper);
}

// normal . p for each of the points of a leaf, and what rounding can do to any of them.
struct SignedDistances {
  alignas(32) double of[leaf_size + lanes];  // the last one filled up
  double uncertainty;
};
inline void distances_of(const Point* points, Point normal, SignedDistances& distances) {
  const double* coordinates = &points[0].x;
  const Lanes weight = {normal.x, normal.y, normal.x, normal.y};
  Lanes size = splat(0);
  for (std::size_t i = 0; i < leaf_size; i += lanes) {
    const Lanes first = load(coordinates + 2 * i) * weight, second = load(coordinates + 2 * i + 4) * weight;
    const Lanes by_x = __builtin_shufflevector(first, second, 0, 2, 4, 6);
    const Lanes by_y = __builtin_shufflevector(first, second, 1, 3, 5, 7);
    store(distances.of + i, by_x + by_y);
    size = max(size, absolute(by_x) + absolute(by_y));
  }
  const double by_x = points[leaf_size].x * normal.x, by_y = points[leaf_size].y * normal.y;
  store(distances.of + leaf_size, splat(by_x + by_y));
  size = max(size, absolute(splat(by_x)) + absolute(splat(by_y)));
  distances.uncertainty = greatest(size) * 0x1p-51 + 0x1p-1000;  // three roundings; products may underflow
}

inline void fit_slab(const Point* points, Slab& slab) {
  slab.normal = {points[0].y - points[leaf_size].y, points[leaf_size].x - points[0].x};
  if (!__builtin_isfinite(slab.normal.x) || !__builtin_isfinite(slab.normal.y)) slab.normal = {0, 0};
  SignedDistances distances;
  distances_of(points, slab.normal, distances);
  Lanes low = load(distances.of + leaf_size), high = low;
  for (std::size_t i = 0; i < leaf_size; i += lanes) {
    low = min(low, load(distances.of + i));
    high = max(high, load(distances.of + i));
  }
  slab.low = least(low) - distances.uncertainty;
  slab.high = greatest(high) + distances.uncertainty;
}

// Bit j is set unless segment j of leaf b lies wholly on one side of the slab of leaf a.
inline std::uint32_t meeting_slab(const SegmentBoxes& a, const Point* b) {
  SignedDistances distances;
  distances_of(b, a.slab.normal, distances);
  const Lanes low = splat(a.slab.low - distances.uncertainty), high = splat(a.slab.high + distances.uncertainty);
  std::uint64_t above = 0, below = 0;  // bits of the points
  for (std::size_t i = 0; i < leaf_size + lanes; i += lanes) {
    const Lanes distance = load(distances.of + i);
    above |= static_cast<std::uint64_t>(mask_bits(distance > high)) << i;
    below |= static_cast<std::uint64_t>(mask_bits(distance < low)) << i;
  }
  return ~static_cast<std::uint32_t>((above & above >> 1) | (below & below >> 1));
}

// Four of the boxes against a rectangle.
inline LaneMask meeting_four(const double* min_x, const double* max_x, const double* min_y, const double* max_y,
                             Lanes left, Lanes right, Lanes bottom, Lanes top) {
  return (load(min_x) <= right) & (load(max_x) >= left) & (load(min_y) <= top) & (load(max_y) >= bottom);
}
// Four of the groups, from the given one on.
inline LaneMask meeting_groups_from(const SegmentBoxes& boxes, std::size_t g, Lanes left, Lanes right, Lanes bottom,
                                    Lanes top) {
  return meeting_four(boxes.group_min_x + g, boxes.group_max_x + g, boxes.group_min_y + g, boxes.group_max_y + g, left,
                      right, bottom, top);
}

// Bit g is set where group g meets the rectangle.
inline unsigned meeting_groups(const SegmentBoxes& boxes, Lanes left, Lanes right, Lanes bottom, Lanes top) {
  unsigned groups = 0;
  for (std::size_t g = 0; g < SegmentBoxes::groups; g += lanes) {
    groups |= mask_bits(meeting_groups_from(boxes, g, left, right, bottom, top)) << g;
  }
  return groups;
}

// The box of the groups that meet a rectangle; empty where there are none.
inline void box_of_meeting_groups(const SegmentBoxes& boxes, const Box& rectangle, Box& box) {
  const Lanes left = splat(rectangle.min_x()), right = splat(rectangle.max_x()), bottom = splat(rectangle.min_y()),
              top = splat(rectangle.max_y()), none = splat(__builtin_inf());
  Lanes rows[lanes] = {none, none, none, none};
  for (std::size_t g = 0; g < SegmentBoxes::groups; g += lanes) {
    const LaneMask met = meeting_groups_from(boxes, g, left, right, bottom, top);
    rows[0] = min(rows[0], met ? load(boxes.group_min_x + g) : none);
    rows[1] = min(rows[1], met ? load(boxes.group_min_y + g) : none);
    rows[2] = min(rows[2], met ? -load(boxes.group_max_x + g) : none);
    rows[3] = min(rows[3], met ? -load(boxes.group_max_y + g) : none);
  }
  transpose(rows);
  store(box.lane, min(min(rows[0], rows[1]), min(rows[2], rows[3])));
}

// Bit i is set where box i meets the rectangle.
inline std::uint32_t meeting_bits(const SegmentBoxes& boxes, double min_x, double max_x, double min_y, double max_y) {
  const Lanes left = splat(min_x), right = splat(max_x), bottom = splat(min_y), top = splat(max_y);
  std::uint32_t bits = 0;
  for (unsigned groups = meeting_groups(boxes, left, right, bottom, top); groups != 0; groups &= groups - 1) {
    const auto i = static_cast<std::size_t>(__builtin_ctz(groups)) * lanes;
    bits |= mask_bits(meeting_four(boxes.min_x + i, boxes.max_x + i, boxes.min_y + i, boxes.max_y + i, left, right,
                                   bottom, top))
            << i;
  }
  return bits;
}

// The bits 0, 2, 4, ... of a number, side by side.
inline std::uint32_t even_bits(std::uint64_t bits) {
  bits &= 0x5555555555555555;
  bits = (bits | bits >> 1) & 0x3333333333333333;
  bits = (bits | bits >> 2) & 0x0f0f0f0f0f0f0f0f;
  bits = (bits | bits >> 4) & 0x00ff00ff00ff00ff;
  bits = (bits | bits >> 8) & 0x0000ffff0000ffff;
  return static_cast<std::uint32_t>(bits | bits >> 16);
}

// Bit j is set where the box of segment j of the leaf meets the other box and is no point: runs of repeated vertices
// would meet each other.
inline std::uint32_t meeting_box(const Point* points, const Box& other) {
  const double* coordinates = &points[0].x;
  const Lanes lower = {other.min_x(), other.min_y(), other.min_x(), other.min_y()},
              upper = {other.max_x(), other.max_y(), other.max_x(), other.max_y()};
  std::uint64_t meets = 0, moves = 0;  // bits for x and y in turns
  for (std::size_t i = 0; i < 2 * leaf_size; i += lanes) {
    const Lanes begin = load(coordinates + i), end = load(coordinates + i + 2);
    const Lanes low = min(begin, end), high = max(begin, end);
    meets |= static_cast<std::uint64_t>(mask_bits((low <= upper) & (high >= lower))) << i;
    moves |= static_cast<std::uint64_t>(mask_bits(low < high)) << i;
  }
  return even_bits(meets & meets >> 1 & (moves | moves >> 1));
}

inline std::size_t find_meeting(const SegmentBoxes& a, std::uint32_t a_begin, const Point* b, const Box& b_box,
                                std::uint32_t b_begin, SegmentPair* pairs, std::uint32_t wanted) {
  // Often the boxes of two leaves meet and those of their parts do not.
  Box near;
  box_of_meeting_groups(a, b_box, near);
  if (near.lane[0] == __builtin_inf()) return 0;
  std::uint32_t candidates = wanted & meeting_box(b, near);
  if (candidates != 0) candidates &= meeting_slab(a, b);
  std::size_t count = 0;
  for (; candidates != 0; candidates &= candidates - 1) {
    const auto j = static_cast<std::uint32_t>(__builtin_ctz(candidates));
    const Box box = Box::of(b[j], b[j + 1]);
    std::uint32_t met = meeting_bits(a, box.min_x(), box.max_x(), box.min_y(), box.max_y());
    for (; met != 0; met &= met - 1) {
      pairs[count++] = {a_begin + static_cast<std::uint32_t>(__builtin_ctz(met)), b_begin + j};
    }
  }
  return count;
}

inline void all_segment_boxes(const Point* points, SegmentBoxes& boxes) {
  boxes_of(points, boxes);
  group_boxes(boxes);
  fit_slab(points, boxes.slab);
}

}  // namespace
}  // namespace lober::detail
