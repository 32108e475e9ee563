// Strips round the nodes of a box tree (private to index/), for searches of two curves of which one is folded.
#pragma once

#include <array>

#include "engine/geometry/index/box_tree.hpp"
#include "kernels/strip.hpp"
#include "lober/base/buffer.hpp"

namespace lober::detail {

class NodeStrips {
 public:
  /// The tree has to outlive them. O(N), parallel; 4 bytes a point.
  explicit NodeStrips(const BoxTree& tree);

  [[nodiscard]] const BoxTree& tree() const { return tree_; }
  [[nodiscard]] BoxLevel level(std::uint32_t level) const { return tree_.level(level); }
  /// Those of a level.
  [[nodiscard]] const Strip* strips(std::uint32_t level) const { return &strips_[begin_[level]]; }

 private:
  const BoxTree& tree_;
  std::array<std::uint32_t, 32> begin_{};
  Buffer<Strip> strips_;
};

}  // namespace lober::detail
