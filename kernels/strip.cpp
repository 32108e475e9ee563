#include "kernels/strip.hpp"

#include "kernels/cpu.hpp"

#include "kernels/join_strips.inl"
#include "kernels/leaf_strip.inl"
#include "kernels/strip_filter.inl"

namespace lober::detail {

void leaf_strip_avx2(const Point* points, Strip& strip);
void join_strips_avx2(const Strip* below, std::size_t count, Strip* above);
std::size_t keep_near_avx2(const Strip& strip, StripPyramid pyramid, TreeNode* list, std::size_t count);

void leaf_strip(const Point* points, Strip& strip) {
  has_avx2() ? leaf_strip_avx2(points, strip) : fit_strip(points, strip);
}

void join_strips(const Strip* below, std::size_t count, Strip* above) {
  has_avx2() ? join_strips_avx2(below, count, above) : join_all(below, count, above);
}

std::size_t keep_near(const Strip& strip, StripPyramid pyramid, TreeNode* list, std::size_t count) {
  return has_avx2() ? keep_near_avx2(strip, pyramid, list, count) : keep_strips(strip, pyramid, list, count);
}

}  // namespace lober::detail
