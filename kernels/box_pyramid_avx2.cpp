#include "kernels/box_pyramid.hpp"
#include "kernels/simd.hpp"

#include "kernels/box_pyramid.inl"

namespace lober::detail {

void distribute_avx2(const Box* four, std::size_t boxes, BoxPyramid pyramid, const TreeNode* list, std::size_t count,
                     TreeNode* const* met, std::size_t* met_count) {
  distribute_nodes(four, boxes, pyramid, list, count, met, met_count);
}

SplitCounts refine_avx2(const Box& box, double largest, BoxPyramid pyramid, const TreeNode* list, std::size_t count,
                        TreeNode* kept, TreeNode* split) {
  return refine_nodes(box, largest, pyramid, list, count, kept, split);
}

}  // namespace lober::detail
