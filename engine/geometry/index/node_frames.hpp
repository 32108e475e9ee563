// Slanted rectangles round the nodes of a box tree (private to index/).
//
// Where folds run side by side and slanted, the boxes of their nodes overlap those of many neighbours, and rectangles
// along each node's own chord do not. They are made only for searches that need them, in one pass over the points, and
// for every second level, since walks go down by two.
#pragma once

#include "engine/geometry/index/box_tree.hpp"
#include "kernels/frame_filter.hpp"
#include "lober/base/buffer.hpp"

namespace lober::detail {

class NodeFrames {
 public:
  /// O(N), parallel; 2 bytes a point.
  explicit NodeFrames(const BoxTree& tree);

  [[nodiscard]] FramePyramid pyramid() const { return {frames_.data(), begin_.data()}; }
  /// The frames of four nodes of an even level, of which `node` is one: number node.index % 4 of them.
  [[nodiscard]] const FourFrames& four(TreeNode node) const {
    return frames_[begin_[node.level / levels_at_once] + node.index / nodes_at_once];
  }

 private:
  std::array<std::uint32_t, 16> begin_{};
  Buffer<FourFrames> frames_;
};

}  // namespace lober::detail
