// The leaves of one curve that may meet, where it is folded upon itself many times (private to index/).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/geometry/index/box_tree.hpp"
#include "engine/geometry/index/index.hpp"
#include "lober/base/buffer.hpp"

namespace lober::detail {

/// For each leaf the leaves from it on that it may meet in more than a common end, ascending; itself, unless it is one
/// monotone run. Leaves of one point meet nothing.
class NearLeaves {
 public:
  /// O(leaves log leaves) for folds side by side, parallel; the same for any number of threads.
  NearLeaves(const BoxTree& tree, SearchCounts& counts);
  /// False where many leaves lie across each other: then there are no lists.
  [[nodiscard]] bool is_complete() const { return is_complete_; }
  [[nodiscard]] std::span<const TreeNode> of(std::uint32_t leaf) const {
    return {others_.data() + begin_[leaf], others_.data() + end_[leaf]};
  }

 private:
  bool is_complete_ = false;
  std::vector<std::uint32_t> begin_, end_;
  std::vector<TreeNode> others_;
};

}  // namespace lober::detail
