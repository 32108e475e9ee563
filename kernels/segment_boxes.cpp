#include "kernels/segment_boxes.hpp"

#include <algorithm>
#include <cmath>

#include "kernels/cpu.hpp"
#include "kernels/simd.hpp"

#include "kernels/segment_boxes.inl"

namespace lober::detail {

static_assert(leaf_size == 32, "a leaf's segments are the bits of a 32-bit word");

void segment_boxes_avx2(const Point* points, SegmentBoxes& boxes);
std::size_t meeting_segments_avx2(const SegmentBoxes& a, std::uint32_t a_begin, const Point* b, const Box& b_box,
                                  std::uint32_t b_begin, SegmentPair* pairs);

void segment_boxes(const Point* points, SegmentBoxes& boxes) {
  if (has_avx2()) {
    segment_boxes_avx2(points, boxes);
  } else {
    boxes_of(points, boxes);
    group_boxes(boxes);
    fit_slab(points, boxes.slab);
  }
}

void leaf_slab_avx2(const Point* points, Slab& slab);
void leaf_slab(const Point* points, Slab& slab) {
  if (has_avx2()) {
    leaf_slab_avx2(points, slab);
  } else {
    fit_slab(points, slab);
  }
}

std::size_t meeting_segments(const SegmentBoxes& a, std::uint32_t a_begin, const Point* b, const Box& b_box,
                             std::uint32_t b_begin, SegmentPair* pairs) {
  return has_avx2() ? meeting_segments_avx2(a, a_begin, b, b_box, b_begin, pairs)
                    : find_meeting(a, a_begin, b, b_box, b_begin, pairs);
}

}  // namespace lober::detail
