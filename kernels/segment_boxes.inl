// Body of segment_boxes and meeting_segments (kernels/all.inl).
#pragma once

#include "kernels/eight.hpp"
#include "kernels/segment_boxes.hpp"

namespace lober::detail {
namespace {

inline void boxes_of(const Point* points, SegmentBoxes& boxes) {
  const double* coordinates = &points[0].x;
  for (std::size_t i = 0; i < leaf_size; i += widest) {
    const double* const begin = coordinates + 2 * i;
    const Widest begin0 = load_widest(begin), begin1 = load_widest(begin + widest);
    const Widest end0 = load_widest(begin + 2), end1 = load_widest(begin + widest + 2);
    const Widest low0 = min(begin0, end0), low1 = min(begin1, end1);
    const Widest high0 = max(begin0, end0), high1 = max(begin1, end1);
    store(boxes.min_x + i, evens(low0, low1));
    store(boxes.min_y + i, odds(low0, low1));
    store(boxes.max_x + i, evens(high0, high1));
    store(boxes.max_y + i, odds(high0, high1));
  }
}

// Least (or greatest) of each group of four.
template <typename Pick>
inline void by_groups(const double* values, double* result, const Pick& pick) {
  for (std::size_t group = 0; group < SegmentBoxes::groups; group += widest) {
    Widest rows[4];
    for (std::size_t k = 0; k < 4; ++k) rows[k] = load_widest(values + 4 * group + k * widest);
    const Widest first = pick(evens(rows[0], rows[1]), odds(rows[0], rows[1]));
    const Widest second = pick(evens(rows[2], rows[3]), odds(rows[2], rows[3]));
    store(result + group, pick(evens(first, second), odds(first, second)));
  }
}

inline void group_boxes(SegmentBoxes& boxes) {
  const auto lower = [](Widest a, Widest b) { return min(a, b); };
  const auto upper = [](Widest a, Widest b) { return max(a, b); };
  by_groups(boxes.min_x, boxes.group_min_x, lower);
  by_groups(boxes.min_y, boxes.group_min_y, lower);
  by_groups(boxes.max_x, boxes.group_max_x, upper);
  by_groups(boxes.max_y, boxes.group_max_y, upper);
}

// normal . p for each of the points of a leaf but the last, that of the last, and what rounding can do to any of them.
struct SignedDistances {
  Widest of[leaf_size / widest];
  double last;
  double uncertainty;
};
inline void distances_of(const Point* points, Point normal, SignedDistances& distances) {
  const double* coordinates = &points[0].x;
  const Widest weight = repeat(Lanes{normal.x, normal.y, normal.x, normal.y});
  const double last_by_x = points[leaf_size].x * normal.x, last_by_y = points[leaf_size].y * normal.y;
  Widest size = splat_widest(__builtin_fabs(last_by_x) + __builtin_fabs(last_by_y));
  for (std::size_t k = 0; k < leaf_size / widest; ++k) {
    const double* const pair = coordinates + 2 * widest * k;
    const Widest first = load_widest(pair) * weight, second = load_widest(pair + widest) * weight;
    const Widest by_x = evens(first, second), by_y = odds(first, second);
    distances.of[k] = by_x + by_y;
    size = max(size, absolute(by_x) + absolute(by_y));
  }
  distances.last = last_by_x + last_by_y;
  // Three roundings; products may underflow.
  distances.uncertainty = greatest(greatest_four(size)) * 0x1p-51 + 0x1p-1000;
}

inline void fit_slab(const Point* points, Slab& slab) {
  slab.normal = {points[0].y - points[leaf_size].y, points[leaf_size].x - points[0].x};
  if (!__builtin_isfinite(slab.normal.x) || !__builtin_isfinite(slab.normal.y)) slab.normal = {0, 0};
  SignedDistances distances;
  distances_of(points, slab.normal, distances);
  Widest low = splat_widest(distances.last), high = low;
  for (const Widest distance : distances.of) {
    low = min(low, distance);
    high = max(high, distance);
  }
  slab.low = least(least_four(low)) - distances.uncertainty;
  slab.high = greatest(greatest_four(high)) + distances.uncertainty;
}

// Bit j is set unless segment j of leaf b lies wholly on one side of the slab of leaf a.
inline std::uint32_t meeting_slab(const SegmentBoxes& a, const Point* b) {
  SignedDistances distances;
  distances_of(b, a.slab.normal, distances);
  const double lowest = a.slab.low - distances.uncertainty, highest = a.slab.high + distances.uncertainty;
  const Widest low = splat_widest(lowest), high = splat_widest(highest);
  std::uint64_t above = static_cast<std::uint64_t>(distances.last > highest) << leaf_size,
                below = static_cast<std::uint64_t>(distances.last < lowest) << leaf_size;  // bits of the points
  for (std::size_t k = 0; k < leaf_size / widest; ++k) {
    above |= static_cast<std::uint64_t>(mask_bits(less(high, distances.of[k]))) << widest * k;
    below |= static_cast<std::uint64_t>(mask_bits(less(distances.of[k], low))) << widest * k;
  }
  return ~static_cast<std::uint32_t>((above & above >> 1) | (below & below >> 1));
}

// Boxes against a rectangle, as many as there is room for.
struct Sides {
  Widest left, right, bottom, top;
};
inline void splat_sides(const Box& box, Sides& sides) {
  sides = {splat_widest(box.min_x()), splat_widest(box.max_x()), splat_widest(box.min_y()), splat_widest(box.max_y())};
}
inline auto meeting(const double* min_x, const double* max_x, const double* min_y, const double* max_y,
                    const Sides& sides) {
  return both(both(at_most(load_widest(min_x), sides.right), at_most(sides.left, load_widest(max_x))),
              both(at_most(load_widest(min_y), sides.top), at_most(sides.bottom, load_widest(max_y))));
}
// The segments and the groups from the given one on.
inline auto meeting_segments_from(const SegmentBoxes& boxes, std::size_t i, const Sides& sides) {
  return meeting(boxes.min_x + i, boxes.max_x + i, boxes.min_y + i, boxes.max_y + i, sides);
}
inline auto meeting_groups_from(const SegmentBoxes& boxes, std::size_t g, const Sides& sides) {
  return meeting(boxes.group_min_x + g, boxes.group_max_x + g, boxes.group_min_y + g, boxes.group_max_y + g, sides);
}

// The box of the groups that meet a rectangle; empty where there are none.
inline void box_of_meeting_groups(const SegmentBoxes& boxes, const Box& rectangle, Box& box) {
  Sides sides;
  splat_sides(rectangle, sides);
  const Widest none = splat_widest(__builtin_inf());
  Widest corner[4] = {none, none, none, none};
  for (std::size_t g = 0; g < SegmentBoxes::groups; g += widest) {
    const auto met = meeting_groups_from(boxes, g, sides);
    corner[0] = min(corner[0], choose(met, load_widest(boxes.group_min_x + g), none));
    corner[1] = min(corner[1], choose(met, load_widest(boxes.group_min_y + g), none));
    corner[2] = min(corner[2], choose(met, -load_widest(boxes.group_max_x + g), none));
    corner[3] = min(corner[3], choose(met, -load_widest(boxes.group_max_y + g), none));
  }
  Lanes rows[lanes] = {least_four(corner[0]), least_four(corner[1]), least_four(corner[2]), least_four(corner[3])};
  transpose(rows);
  store(box.lane, min(min(rows[0], rows[1]), min(rows[2], rows[3])));
}

// Bit i is set where box i meets the rectangle.
inline std::uint32_t meeting_bits(const SegmentBoxes& boxes, const Box& rectangle) {
  Sides sides;
  splat_sides(rectangle, sides);
  std::uint32_t bits = 0;
#ifdef __AVX512F__
  for (std::size_t i = 0; i < leaf_size; i += widest) bits |= mask_bits(meeting_segments_from(boxes, i, sides)) << i;
#else
  // Groups first: eight tests are more than those of the groups and of one or two of them.
  unsigned groups = 0;
  for (std::size_t g = 0; g < SegmentBoxes::groups; g += widest) {
    groups |= mask_bits(meeting_groups_from(boxes, g, sides)) << g;
  }
  for (; groups != 0; groups &= groups - 1) {
    const auto i = static_cast<std::size_t>(__builtin_ctz(groups)) * lanes;
    bits |= mask_bits(meeting_segments_from(boxes, i, sides)) << i;
  }
#endif
  return bits;
}

// The bits 0, 2, 4, ... of a number, side by side.
inline std::uint32_t even_bits(std::uint64_t bits) {
#ifdef __AVX512F__  // some processors without it are slow at this
  return static_cast<std::uint32_t>(_pext_u64(bits, 0x5555555555555555));
#else
  bits &= 0x5555555555555555;
  bits = (bits | bits >> 1) & 0x3333333333333333;
  bits = (bits | bits >> 2) & 0x0f0f0f0f0f0f0f0f;
  bits = (bits | bits >> 4) & 0x00ff00ff00ff00ff;
  bits = (bits | bits >> 8) & 0x0000ffff0000ffff;
  return static_cast<std::uint32_t>(bits | bits >> 16);
#endif
}

// Bit j is set where the box of segment j of the leaf meets the other box.
inline std::uint32_t meeting_box(const Point* points, const Box& other) {
  const double* coordinates = &points[0].x;
  const Widest lower = repeat(Lanes{other.min_x(), other.min_y(), other.min_x(), other.min_y()}),
               upper = repeat(Lanes{other.max_x(), other.max_y(), other.max_x(), other.max_y()});
  std::uint64_t meets = 0;  // bits for x and y in turns
  for (std::size_t i = 0; i < 2 * leaf_size; i += widest) {
    const Widest begin = load_widest(coordinates + i), end = load_widest(coordinates + i + 2);
    const Widest low = min(begin, end), high = max(begin, end);
    meets |= static_cast<std::uint64_t>(mask_bits(both(at_most(low, upper), at_most(lower, high)))) << i;
  }
  return even_bits(meets & meets >> 1);
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
    if (is_point(box)) continue;  // runs of repeated vertices would meet each other
    std::uint32_t met = meeting_bits(a, box);
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
