#include "engine/geometry/index/node_frames.hpp"

#include <algorithm>

#include "engine/base/parallel/parallel.hpp"

namespace lober::detail {
namespace {

// Calls visit(k, node) for four nodes of a level from `first` on; the last one stands for those that are not there.
template <typename Visit>
void for_four(std::size_t first, std::size_t nodes, const Visit& visit) {
  for (std::size_t k = 0; k < nodes_at_once; ++k) visit(k, std::min(first + k, nodes - 1));
}

void make_frames_of_leaves(const BoxTree& tree, std::size_t first, FourFrames& frames) {
  std::array<const Point*, nodes_at_once> points;
  std::array<const Box*, nodes_at_once> boxes;
  for_four(first, tree.leaves(), [&](std::size_t k, std::size_t leaf) {
    points[k] = tree.leaf_points(leaf);
    boxes[k] = &tree.leaf_boxes()[leaf];
  });
  frames_of_leaves(points, boxes, frames);
}

// The number of those of four leaves whose frames are much smaller than their boxes.
std::size_t small_frames(const BoxTree& tree, std::size_t first) {
  constexpr double much = 0.5;
  FourFrames four;
  make_frames_of_leaves(tree, first, four);
  std::size_t small = 0;
  for_four(first, tree.leaves(), [&](std::size_t k, std::size_t leaf) {
    const Box& box = tree.leaf_boxes()[leaf];
    small += 4 * four.length[k] * four.width[k] < much * box.width() * box.height() ? 1 : 0;
  });
  return small;
}

void make_frames_above(const BoxTree& tree, std::uint32_t level, std::size_t first, const FourFrames* below,
                       FourFrames& frames) {
  std::array<const FourFrames*, nodes_at_once> parts;
  std::array<Chord, nodes_at_once> chords;
  std::array<const Box*, nodes_at_once> boxes;
  for_four(first, tree.nodes(level), [&](std::size_t k, std::size_t node) {
    parts[k] = &below[node];
    chords[k] = {tree.leaf_begin(node << level),
                 tree.leaf_begin(std::min<std::size_t>((node + 1) << level, tree.leaves()))};
    boxes[k] = &tree.box({level, static_cast<std::uint32_t>(node)});
  });
  join_frames(parts, chords, boxes, frames);
}

std::size_t fours_of(const BoxTree& tree, std::uint32_t level) {
  return (tree.nodes(level) + nodes_at_once - 1) / nodes_at_once;
}

}  // namespace

std::size_t NodeFrames::memory(const BoxTree& tree) {
  std::size_t total = 0;
  for (std::uint32_t level = 0; level < tree.levels(); level += levels_at_once) total += fours_of(tree, level);
  return total * sizeof(FourFrames);
}

NodeFrames::NodeFrames(const BoxTree& tree) : tree_(tree) {
  std::size_t total = 0;
  for (std::uint32_t level = 0; level < tree.levels(); level += levels_at_once) {
    begin_[level / levels_at_once] = static_cast<std::uint32_t>(total);
    total += fours_of(tree, level);
  }
  frames_.resize(total);
  for_each_block(fours_of(tree, 0), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) make_frames_of_leaves(tree, nodes_at_once * k, frames_[k]);
  });
  for (std::uint32_t level = levels_at_once; level < tree.levels(); level += levels_at_once) {
    const FourFrames* const below = &frames_[begin_[level / levels_at_once - 1]];
    FourFrames* const here = &frames_[begin_[level / levels_at_once]];
    for_each_block(fours_of(tree, level), 256, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) make_frames_above(tree, level, nodes_at_once * k, below, here[k]);
    });
  }
}

bool frames_are_small(const BoxTree& tree) {
  constexpr std::uint64_t samples = 16, golden = 0x9e3779b9;  // equal steps would meet each fold in the same place
  const std::size_t fours = fours_of(tree, 0);
  std::size_t small = 0;
  for (std::uint64_t k = 0; k < samples; ++k) {
    const std::uint64_t part = k * golden & 0xffffffffU;
    small += small_frames(tree, nodes_at_once * (part * fours >> 32U));
  }
  return 2 * small > samples * nodes_at_once;
}

}  // namespace lober::detail
