#include "kernels/segment_boxes.hpp"

#include <algorithm>
#include <cmath>
#include "kernels/simd.hpp"

#include "kernels/segment_boxes.inl"

namespace lober::detail {

void segment_boxes_avx2(const Point* points, SegmentBoxes& boxes) {
  boxes_of(points, boxes);
  group_boxes(boxes);
  boxes.slab = slab_of(points);
}

Slab leaf_slab_avx2(const Point* points) {
  return slab_of(points);
}

std::size_t meeting_segments_avx2(const SegmentBoxes& a, std::uint32_t a_begin, const Point* b, const Box& b_box,
                                  std::uint32_t b_begin, SegmentPair* pairs) {
  return find_meeting(a, a_begin, b, b_box, b_begin, pairs);
}

}  // namespace lober::detail
