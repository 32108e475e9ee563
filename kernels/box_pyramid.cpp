#include "kernels/box_pyramid.hpp"

#include "kernels/cpu.hpp"
#include "kernels/simd.hpp"

#include "kernels/box_pyramid.inl"

namespace lober::detail {

void distribute_avx2(const Box* four, std::size_t boxes, BoxPyramid pyramid, const TreeNode* list, std::size_t count,
                     TreeNode* const* met, std::size_t* met_count);
SplitCounts refine_avx2(const Box& box, double largest, BoxPyramid pyramid, const TreeNode* list, std::size_t count,
                        TreeNode* kept, TreeNode* split);

void distribute(const Box* four, std::size_t boxes, BoxPyramid pyramid, const TreeNode* list, std::size_t count,
                const std::array<TreeNode*, nodes_at_once>& met, std::array<std::size_t, nodes_at_once>& met_count) {
  if (has_avx2()) {
    distribute_avx2(four, boxes, pyramid, list, count, met.data(), met_count.data());
  } else {
    distribute_nodes(four, boxes, pyramid, list, count, met.data(), met_count.data());
  }
}

SplitCounts refine(const Box& box, double largest, BoxPyramid pyramid, const TreeNode* list, std::size_t count,
                   TreeNode* kept, TreeNode* split) {
  return has_avx2() ? refine_avx2(box, largest, pyramid, list, count, kept, split)
                    : refine_nodes(box, largest, pyramid, list, count, kept, split);
}

}  // namespace lober::detail
