#include "engine/geometry/index/node_strips.hpp"

#include "engine/base/parallel/parallel.hpp"

namespace lober::detail {

NodeStrips::NodeStrips(const BoxTree& tree) : tree_(tree) {
  std::uint32_t total = 0;
  for (std::uint32_t level = 0; level < tree.levels(); ++level) {
    begin_[level] = total;
    total += tree.nodes(level);
  }
  strips_.resize(total);
  for_each_block(tree.leaves(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t leaf = begin; leaf < end; ++leaf) leaf_strip(tree.leaf_points(leaf), strips_[leaf]);
  });
  for (std::uint32_t level = 1; level < tree.levels(); ++level) {
    const Strip* below = &strips_[begin_[level - 1]];
    Strip* here = &strips_[begin_[level]];
    const std::size_t pairs = tree.nodes(level - 1) / 2;
    for_each_block(pairs, 1024, [&](std::size_t begin, std::size_t end) {
      join_strips(below + 2 * begin, end - begin, here + begin);
    });
    if (tree.nodes(level) > pairs) here[pairs] = below[2 * pairs];
  }
}

}  // namespace lober::detail
