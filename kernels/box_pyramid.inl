// Body of distribute and refine (kernels/all.inl).
#pragma once

#include "kernels/box_pyramid.hpp"
#include "kernels/eight.hpp"
#include "kernels/node_lanes.inl"

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

// Bit i is set where box i of four in a row is at most `bound` in all its lanes.
inline unsigned four_within(const Box* four, Widest bound) {
  static_assert(sizeof(Box) == lanes * sizeof(double));
  constexpr std::size_t boxes = widest / lanes;
  unsigned bits = 0;  // those of all lanes
  for (std::size_t k = 0; k < 4; k += boxes) {
    bits |= mask_bits(at_most(load_widest(&four[k].lane[0]), bound)) << lanes * k;
  }
  bits &= bits >> 1U;
  bits &= bits >> 2U & 0x1111U;
  bits |= bits >> 3U;
  return (bits & 3U) | (bits >> 6U & 12U);
}

// Nothing branches on what is kept and what is split either: first all are sorted by that.
inline SplitCounts refine_nodes(const Box& box, double largest, BoxPyramid pyramid, const TreeNode* list,
                                std::size_t count, TreeNode* kept, TreeNode* split) {
  SplitCounts end{0, 0};
  TreeNode* const large = split + 3 * count;  // no more than four nodes are written for each that was read
  std::size_t larger = 0;
  if (largest < 0) {
    for (std::size_t k = 0; k < count; ++k) {
      const TreeNode node = list[k];
      kept[end.kept] = large[larger] = node;
      end.kept += static_cast<std::size_t>(node.level == 0);
      larger += static_cast<std::size_t>(node.level != 0);
    }
  } else {
    for (std::size_t k = 0; k < count; ++k) {
      const TreeNode node = list[k];
      const bool stays = (node.level == 0) | (box_of(pyramid, node).extent() <= largest);
      kept[end.kept] = large[larger] = node;
      end.kept += static_cast<std::size_t>(stays);
      larger += static_cast<std::size_t>(!stays);
    }
  }
  const Widest bound = repeat(-__builtin_shufflevector(load(box.lane), load(box.lane), 2, 3, 0, 1));
  for (std::size_t k = 0; k < larger; ++k) {
    const TreeNode node = large[k];
    const std::uint32_t down = node.level < levels_at_once ? node.level : levels_at_once;
    const TreeNode first{node.level - down, node.index << down};
    const std::uint32_t left = pyramid.size[first.level] - first.index;
    const std::uint32_t present = left < 1U << down ? left : 1U << down;
    const unsigned met = four_within(&box_of(pyramid, first), bound) & ((1U << present) - 1);
    end.split += put_nodes(nodes_from(first), met, split + end.split);
  }
  return end;
}

// Kernels of pairs (kernels/node_lanes.inl).
struct BoxPairs {
  using Level = BoxLevel;
  Lanes four[lanes];
  const double* one;
  bool second_is_one;
  LOBER_INLINE void load_four(const Box* boxes) {
    for (std::size_t k = 0; k < lanes; ++k) four[k] = load(boxes[k].lane);
    transpose(four);
  }
  LOBER_INLINE void first_by_four(Level first, Level second, NodePair pair) {
    load_four(first.boxes + 4 * std::size_t{pair.first});
    one = second.boxes[pair.second].lane;
    second_is_one = true;
  }
  LOBER_INLINE void second_by_four(Level first, Level second, NodePair pair) {
    load_four(second.boxes + 4 * std::size_t{pair.second});
    one = first.boxes[pair.first].lane;
    second_is_one = false;
  }
  LOBER_INLINE unsigned meet() const {
    return mask_bits((four[0] <= splat(-one[2])) & (four[1] <= splat(-one[3])) & (four[2] <= splat(-one[0])) &
                     (four[3] <= splat(-one[1])));
  }
  LOBER_INLINE unsigned second_is_small() const {
    // Extents with their signs changed.
    const Lanes of_four = (four[0] + four[2]) + (four[1] + four[3]);
    const Lanes of_one = splat((one[0] + one[2]) + (one[1] + one[3]));
    return mask_bits(second_is_one ? of_one >= of_four : of_four >= of_one);
  }
};

}  // namespace
}  // namespace lober::detail
