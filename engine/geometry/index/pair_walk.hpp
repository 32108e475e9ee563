// The walk of one tree against another, or against itself, by boxes or by frames (private to index/): from a node to
// all of those some levels below it at once, with what each of them meets.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/geometry/index/index.hpp"
#include "engine/geometry/index/node_frames.hpp"
#include "engine/geometry/index/node_strips.hpp"
#include "lober/base/buffer.hpp"

namespace lober::detail {

struct PairList;
struct PairsByLevel;

/// Lists of nodes, one behind the other: what each of the nodes of a level below one meets.
class MeetingLists {
 public:
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(end_.size()); }
  [[nodiscard]] std::span<const TreeNode> operator[](std::uint32_t k) const {
    const std::uint32_t begin = k == 0 ? 0 : end_[k - 1];
    return {met_.data() + begin, end_[k] - begin};
  }

 private:
  template <typename Nodes>
  friend class PairWalk;
  Buffer<TreeNode> met_;
  std::vector<std::uint32_t> end_;
};

/// The nodes of a tree with their boxes.
class NodeBoxes {
 public:
  explicit NodeBoxes(const BoxTree& tree) : tree_(tree) {}
  [[nodiscard]] const BoxTree& tree() const { return tree_; }
  [[nodiscard]] BoxLevel level(std::uint32_t level) const { return tree_.level(level); }

 private:
  const BoxTree& tree_;
};

/// `Nodes`: NodeBoxes, NodeStrips, which are boxes first, or NodeFrames.
template <typename Nodes>
class PairWalk {
 public:
  /// Two trees, or one as two. Both have to outlive the walk.
  PairWalk(const Nodes& first, const Nodes& second) : PairWalk(first, second, false) {}
  /// A tree with itself: each pair of nodes once, and none between which there is nothing (nothing_between).
  explicit PairWalk(const Nodes& nodes) : PairWalk(nodes, nodes, true) {}

  /// Fills the lists of the nodes of `level` below `top`, which may lie above the root: the nodes of the second tree,
  /// out of those in `list` and below these, which they may meet as far as these tell: leaves, or such as are at most
  /// as large as the node where that is not a leaf. All levels are even, and `level` is lower than that of `top`. Ends
  /// earlier, two levels below `top` at the earliest, where there are more than `enough` pairs. Returns the level that
  /// it came to. Adds the number of boxes, frames and strips tested.
  std::uint32_t go_down(TreeNode top, std::uint32_t level, std::span<const TreeNode> list, std::size_t enough,
                        MeetingLists& lists, SearchCounts& counts) const;

 private:
  PairWalk(const Nodes& first, const Nodes& second, bool is_self)
      : first_(first),
        second_(second),
        is_self_(is_self),
        stalls_(first.tree().stalls() || second.tree().stalls()),
        tree_(second.tree().as_self()) {}
  void step_down(std::uint32_t level, const PairsByLevel& from, PairsByLevel& to, SearchCounts& counts) const;
  void drop_apart(PairList& near, std::size_t from, PairList& far, std::uint32_t level,
                  std::uint32_t second_level) const;
  [[nodiscard]] bool is_far(TreeNode first, TreeNode second) const;
  [[nodiscard]] bool is_left_out(TreeNode first, TreeNode second) const;

  const Nodes& first_;
  const Nodes& second_;
  bool is_self_;
  bool stalls_;
  SelfTree tree_;
};

}  // namespace lober::detail
