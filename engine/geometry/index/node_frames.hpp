// Slanted rectangles round the nodes of a box tree (private to index/).
//
// Where folds run side by side and slanted, the boxes of their nodes overlap those of many neighbours, and rectangles
// along each node's own chord do not. They are made only for searches that need them, in one pass over the points.
#pragma once

#include "engine/geometry/index/box_tree.hpp"
#include "kernels/frame_filter.hpp"
#include "lober/base/buffer.hpp"

namespace lober::detail {

class NodeFrames {
 public:
  /// O(N), parallel; 3 bytes a point.
  explicit NodeFrames(const BoxTree& tree);

  [[nodiscard]] FramePyramid pyramid() const { return {frames_.data(), begin_.data()}; }
  [[nodiscard]] const Frame& of(TreeNode node) const { return frames_[begin_[node.level] + node.index]; }

 private:
  std::array<std::uint32_t, 32> begin_{};
  Buffer<Frame> frames_;
};

}  // namespace lober::detail
