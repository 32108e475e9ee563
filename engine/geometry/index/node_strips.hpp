// Strips round the nodes of a box tree (private to index/), for searches of two curves of which one is folded.
#pragma once

#include <array>

#include "engine/geometry/index/box_tree.hpp"
#include "kernels/strip.hpp"
#include "lober/base/buffer.hpp"

namespace lober::detail {

class NodeStrips {
 public:
  /// O(N), parallel; 4 bytes a point.
  explicit NodeStrips(const BoxTree& tree);

  [[nodiscard]] StripPyramid pyramid() const { return {strips_.data(), begin_.data()}; }
  [[nodiscard]] const Strip& of(TreeNode node) const { return strips_[begin_[node.level] + node.index]; }

 private:
  std::array<std::uint32_t, 32> begin_{};
  Buffer<Strip> strips_;
};

}  // namespace lober::detail
