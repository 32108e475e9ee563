// Slanted rectangles round the nodes of a box tree (private to index/).
//
// Where folds run side by side and slanted, the boxes of their nodes overlap those of many neighbours, and rectangles
// along each node's own chord do not. They are made only for searches that need them, in one pass over the points, and
// for every second level, since walks go down by two. The tree keeps them: the search of a curve for itself and that
// for another one use the same.
#pragma once

#include "engine/geometry/index/box_tree.hpp"
#include "kernels/frame_filter.hpp"
#include "lober/base/buffer.hpp"

namespace lober::detail {

class NodeFrames {
 public:
  /// The tree has to outlive them. O(N), parallel; 2 bytes a point.
  explicit NodeFrames(const BoxTree& tree);

  [[nodiscard]] const BoxTree& tree() const { return tree_; }
  /// Bytes of the frames of a tree.
  [[nodiscard]] static std::size_t memory(const BoxTree& tree);
  /// Those of an even level.
  [[nodiscard]] FramedLevel level(std::uint32_t level) const {
    if (level >= tree_.levels()) return {};
    return {&frames_[begin_[level / levels_at_once]], tree_.nodes(level)};
  }

 private:
  const BoxTree& tree_;
  std::array<std::uint32_t, 16> begin_{};
  Buffer<FourFrames> frames_;
};

/// Whether frames are much smaller than boxes, as a few leaves show: of a curve along the axes they are not. O(1).
[[nodiscard]] bool frames_are_small(const BoxTree& tree);

}  // namespace lober::detail
