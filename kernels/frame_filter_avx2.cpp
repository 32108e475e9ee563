#include "kernels/frame_filter.hpp"
#include "kernels/simd.hpp"

#include "kernels/frame_filter.inl"

namespace lober::detail {

std::size_t keep_near_avx2(const Frame& frame, FramePyramid pyramid, TreeNode* list, std::size_t count) {
  return keep_nodes(frame, pyramid, list, count);
}

}  // namespace lober::detail
