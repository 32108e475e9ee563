#include "kernels/segment_boxes.hpp"

#include <algorithm>
#include <cmath>
#include "kernels/simd.hpp"

#include "kernels/segment_boxes.inl"

namespace lober::detail {

void segment_boxes_avx2(const Point* points, SegmentBoxes& boxes) {
  boxes_of(points, boxes);
  group_boxes(boxes);
  fit_slab(points, boxes.slab);
}

void leaf_slab_avx2(const Point* points, Slab& slab) {
  fit_slab(points, slab);
}

std::size_t meeting_segments_avx2(const SegmentBoxes& a, std::uint32_t a_begin, const Point* b, const Box& b_box,
                                  std::uint32_t b_begin, SegmentPair* pairs) {
  return find_meeting(a, a_begin, b, b_box, b_begin, pairs);
}

}  // namespace lober::detail
