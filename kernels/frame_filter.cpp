#include "kernels/frame_filter.hpp"

#include "kernels/cpu.hpp"
#include "kernels/simd.hpp"

#include "kernels/frame_filter.inl"

namespace lober::detail {

std::size_t keep_near_avx2(const Frame& frame, FramePyramid pyramid, TreeNode* list, std::size_t count);

std::size_t keep_near(const Frame& frame, FramePyramid pyramid, TreeNode* list, std::size_t count) {
  return has_avx2() ? keep_near_avx2(frame, pyramid, list, count) : keep_nodes(frame, pyramid, list, count);
}

}  // namespace lober::detail
