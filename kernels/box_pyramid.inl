// Body of distribute and refine (kernels/all.inl).
#pragma once

#include "kernels/box_pyramid.hpp"
#include "kernels/simd.hpp"

namespace lober::detail {
namespace {

inline const Box& box_of(BoxPyramid pyramid, TreeNode node) {
  return pyramid.boxes[pyramid.begin[node.level] + node.index];
}

inline void distribute_nodes(const Box* four, std::size_t boxes, BoxPyramid pyramid, const TreeNode* list,
                             std::size_t count, TreeNode* const* met, std::size_t* met_count) {
  static_assert(nodes_at_once == lanes);
  Lanes lane[lanes];
  for (std::size_t k = 0; k < lanes; ++k) lane[k] = load(four[k].lane);
  transpose(lane);
  std::size_t end[nodes_at_once] = {};
  const unsigned valid = (1U << boxes) - 1;
  for (std::size_t k = 0; k < count; ++k) {
    const TreeNode node = list[k];
    const double* other = box_of(pyramid, node).lane;
    const unsigned bits = valid & mask_bits((lane[0] <= splat(-other[2])) & (lane[1] <= splat(-other[3])) &
                                            (lane[2] <= splat(-other[0])) & (lane[3] <= splat(-other[1])));
    for (std::size_t i = 0; i < nodes_at_once; ++i) {
      met[i][end[i]] = node;
      end[i] += bits >> i & 1U;
    }
  }
  for (std::size_t i = 0; i < nodes_at_once; ++i) met_count[i] = end[i];
}

inline SplitCounts refine_nodes(const Box& box, double largest, BoxPyramid pyramid, const TreeNode* list,
                                std::size_t count, TreeNode* kept, TreeNode* split) {
  const Lanes bound = -__builtin_shufflevector(load(box.lane), load(box.lane), 2, 3, 0, 1);
  SplitCounts end{0, 0};
  for (std::size_t k = 0; k < count; ++k) {
    const TreeNode node = list[k];
    if (node.level == 0 || box_of(pyramid, node).extent() <= largest) {
      kept[end.kept++] = node;
      continue;
    }
    const std::uint32_t down = node.level < levels_at_once ? node.level : levels_at_once;
    const TreeNode first{node.level - down, node.index << down};
    const Box* below = &box_of(pyramid, first);
    const std::uint32_t left = pyramid.size[first.level] - first.index;
    const std::uint32_t present = left < 1U << down ? left : 1U << down;
    for (std::uint32_t i = 0; i < nodes_at_once; ++i) {
      const bool meets = mask_bits(load(below[i].lane) <= bound) == 15;
      split[end.split] = {first.level, first.index + i};
      end.split += static_cast<unsigned>(meets) & static_cast<unsigned>(i < present);
    }
  }
  return end;
}

}  // namespace
}  // namespace lober::detail
