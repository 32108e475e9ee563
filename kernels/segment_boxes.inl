// Body of segment_boxes and meeting_segments, compiled once for plain x86-64 and once for AVX2 (kernels/simd.hpp).

namespace {

using namespace lober;

inline void boxes_of(const Point* points, SegmentBoxes& boxes) {
  const double* coordinates = &points[0].x;
  for (std::size_t i = 0; i < leaf_size; i += lanes) {
    const Lanes begin0 = load(coordinates + 2 * i), begin1 = load(coordinates + 2 * i + 4);
    const Lanes end0 = load(coordinates + 2 * i + 2), end1 = load(coordinates + 2 * i + 6);
    const Lanes low0 = min(begin0, end0), low1 = min(begin1, end1);
    const Lanes high0 = max(begin0, end0), high1 = max(begin1, end1);
    store(boxes.min_x + i, __builtin_shuffle(low0, low1, LaneMask{0, 2, 4, 6}));
    store(boxes.min_y + i, __builtin_shuffle(low0, low1, LaneMask{1, 3, 5, 7}));
    store(boxes.max_x + i, __builtin_shuffle(high0, high1, LaneMask{0, 2, 4, 6}));
    store(boxes.max_y + i, __builtin_shuffle(high0, high1, LaneMask{1, 3, 5, 7}));
  }
}

// Bit i is set where box i meets the rectangle.
inline std::uint32_t meeting_bits(const SegmentBoxes& boxes, double min_x, double max_x, double min_y, double max_y) {
  const Lanes left = splat(min_x), right = splat(max_x), bottom = splat(min_y), top = splat(max_y);
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < leaf_size; i += lanes) {
    const LaneMask both = (load(boxes.min_x + i) <= right) & (load(boxes.max_x + i) >= left) &
                          (load(boxes.min_y + i) <= top) & (load(boxes.max_y + i) >= bottom);
    bits |= mask_bits(both) << i;
  }
  return bits;
}

inline std::size_t find_meeting(const SegmentBoxes& a, const Box& a_box, std::uint32_t a_begin, const Point* b,
                                std::uint32_t b_begin, SegmentPair* pairs) {
  SegmentBoxes b_boxes;
  boxes_of(b, b_boxes);
  std::size_t count = 0;
  std::uint32_t candidates = meeting_bits(b_boxes, a_box.min_x(), a_box.max_x(), a_box.min_y(), a_box.max_y());
  for (; candidates != 0; candidates &= candidates - 1) {
    const auto j = static_cast<std::uint32_t>(__builtin_ctz(candidates));
    std::uint32_t met = meeting_bits(a, b_boxes.min_x[j], b_boxes.max_x[j], b_boxes.min_y[j], b_boxes.max_y[j]);
    for (; met != 0; met &= met - 1) {
      pairs[count++] = {a_begin + static_cast<std::uint32_t>(__builtin_ctz(met)), b_begin + j};
    }
  }
  return count;
}

}  // namespace
