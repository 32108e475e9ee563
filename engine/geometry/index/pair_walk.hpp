// The walk of one tree of boxes against another, or against itself, by boxes, frames or strips: from a node to all of
// those some levels below it at once, with what each of them meets. For trees of curves and of smooth arcs.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/geometry/index/box_tree.hpp"
#include "engine/geometry/index/node_frames.hpp"
#include "engine/geometry/index/node_strips.hpp"
#include "kernels/box_pyramid.hpp"
#include "kernels/frame_filter.hpp"
#include "kernels/strip.hpp"
#include "lober/base/buffer.hpp"
#include "lober/overlay/counts.hpp"

namespace lober::detail {

/// Where walks of trees of that many levels begin: a node of an even level, at the root or above it, and so high that
/// they go down from it, since they split what is met on their way.
inline TreeNode top_of(std::uint32_t levels) {
  return {std::max(levels / 2 * 2, levels_at_once), 0};
}
/// The nodes of even levels at the root or below it.
inline std::vector<TreeNode> roots_of(std::uint32_t levels) {
  const std::uint32_t root = levels - 1;
  if (root % 2 == 0) return {{root, 0}};
  return {{root - 1, 0}, {root - 1, 1}};
}

/// More pairs than these are not held at once on the way down to leaves: they may be most of all pairs of leaves.
inline constexpr std::size_t pairs_at_once = std::size_t{1} << 16;

struct PairList {
  Buffer<NodePair> pair;
  std::size_t count = 0;
  NodePair* room_for(std::size_t more) {
    if (pair.size() < count + more) pair.resize(2 * (count + more));
    return pair.data() + count;
  }
};

// By half the level of the second node. Pairs near by along the curve are apart from the others, where there is nothing
// to ask.
struct PairsByLevel {
  std::array<PairList, 16> near, far;
  std::size_t levels = 0;  // the lists behind these are empty

  void clear(std::size_t levels_from_now) {
    levels = levels_from_now;
    for (std::size_t k = 0; k < levels; ++k) near[k].count = far[k].count = 0;
  }
  void add(TreeNode first, TreeNode second, bool is_near) {
    PairList& pairs = is_near ? near[second.level / 2] : far[second.level / 2];
    *pairs.room_for(1) = {first.index, second.index};
    ++pairs.count;
  }
  [[nodiscard]] std::size_t count() const {
    std::size_t sum = 0;
    for_each_list([&](const PairList& pairs, std::uint32_t) { sum += pairs.count; });
    return sum;
  }
  // Calls visit(pairs, level of the second nodes).
  template <typename Visit>
  void for_each_list(const Visit& visit) const {
    for (std::size_t k = 0; k < levels; ++k) {
      visit(near[k], static_cast<std::uint32_t>(2 * k));
      visit(far[k], static_cast<std::uint32_t>(2 * k));
    }
  }
};

/// Lists of nodes, one behind the other: what each of the nodes of a level below one meets.
class MeetingLists {
 public:
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(end_.size()); }
  [[nodiscard]] std::span<const TreeNode> operator[](std::uint32_t k) const {
    const std::uint32_t begin = k == 0 ? 0 : end_[k - 1];
    return {met_.data() + begin, end_[k] - begin};
  }
  /// The lists of the second nodes of pairs, for `nodes` first ones from number `first` on.
  void sort_in(const PairsByLevel& pairs, std::uint32_t first, std::size_t nodes) {
    end_.assign(nodes, 0);
    pairs.for_each_list([&](const PairList& found, std::uint32_t) {
      for (std::size_t k = 0; k < found.count; ++k) ++end_[found.pair[k].first - first];
    });
    std::uint32_t total = 0;
    for (std::uint32_t& end : end_) total += std::exchange(end, total);
    if (met_.size() < total) met_.resize(2 * std::size_t{total});
    pairs.for_each_list([&](const PairList& found, std::uint32_t second_level) {
      for (std::size_t k = 0; k < found.count; ++k) {
        const NodePair pair = found.pair[k];
        met_[end_[pair.first - first]++] = {second_level, pair.second};
      }
    });
  }

 private:
  Buffer<TreeNode> met_;
  std::vector<std::uint32_t> end_;
};

/// Which pairs of nodes of two trees, or of one with itself, are left out: those between which there is nothing
/// (nothing_between), and each pair of one tree once; points that a curve stays in.
class LeftOutOfTrees {
 public:
  LeftOutOfTrees(const BoxTree& first, const BoxTree& second)
      : first_(first), second_(second), stalls_(first.stalls() || second.stalls()) {}
  explicit LeftOutOfTrees(const BoxTree& tree) : LeftOutOfTrees(tree, tree) {
    is_self_ = true;
    tree_ = tree.as_self();
  }

  /// Whether neither a pair nor any below it is left out.
  [[nodiscard]] bool none_below(TreeNode first, TreeNode second) const {
    if (stalls_) return false;
    return !is_self_ || second.index << second.level >= far_behind(first, first);
  }
  /// Whether a pair is.
  [[nodiscard]] bool operator()(TreeNode first, TreeNode second) const {
    if (stalls_ && (is_point(first_.box(first)) || is_point(second_.box(second)))) return true;
    return is_self_ && nothing_between(tree_, first, second);
  }

 private:
  const BoxTree& first_;
  const BoxTree& second_;
  bool stalls_;
  bool is_self_ = false;
  SelfTree tree_{};
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

/// `Nodes` give the boxes or frames of a level, for pairs_below_first and pairs_below_second, and maybe strips besides,
/// which are asked for where boxes meet. `LeftOut` is a rule like LeftOutOfTrees.
template <typename Nodes, typename LeftOut = LeftOutOfTrees>
class PairWalk {
 public:
  /// The nodes of two trees, which have to outlive the walk.
  PairWalk(const Nodes& first, const Nodes& second, LeftOut left_out)
      : first_(first), second_(second), left_out_(left_out) {}
  /// Those of the trees of two curves, or of one as two.
  PairWalk(const Nodes& first, const Nodes& second) : PairWalk(first, second, {first.tree(), second.tree()}) {}
  /// The tree of a curve with itself.
  explicit PairWalk(const Nodes& nodes) : PairWalk(nodes, nodes, LeftOut(nodes.tree())) {}

  /// The pairs of the nodes of `level` below `top`, which may lie above the root, with the nodes of the second tree,
  /// out of those in `list` and below these, which they may meet as far as these tell: leaves, or such as are at most
  /// as large as the node where that is not a leaf. All levels are even, and `level` is lower than that of `top`. Ends
  /// earlier, two levels below `top` at the earliest, where there are more than `enough` pairs. Adds the number of
  /// boxes, frames and strips tested.
  struct Below {
    std::uint32_t level;        ///< where the way down ended
    const PairsByLevel& pairs;  ///< until the thread goes down another time
  };
  Below pairs_below(TreeNode top, std::uint32_t level, std::span<const TreeNode> list, std::size_t enough,
                    SearchCounts& counts) const;
  /// The same as a list for each of the nodes below `top`. Returns the level that it came to.
  std::uint32_t go_down(TreeNode top, std::uint32_t level, std::span<const TreeNode> list, std::size_t enough,
                        MeetingLists& lists, SearchCounts& counts) const;

 private:
  void step_down(std::uint32_t level, const PairsByLevel& from, PairsByLevel& to, SearchCounts& counts) const;
  void drop_left_out(PairList& near, std::size_t from, PairList& far, std::uint32_t level,
                     std::uint32_t second_level) const;

  const Nodes& first_;
  const Nodes& second_;
  LeftOut left_out_;
};

// Those of the pairs from number `from` on below which none is left out go to `far`, and those that are left out go.
template <typename Nodes, typename LeftOut>
void PairWalk<Nodes, LeftOut>::drop_left_out(PairList& near, std::size_t from, PairList& far, std::uint32_t level,
                                             std::uint32_t second_level) const {
  NodePair* to_far = far.room_for(near.count - from);
  std::size_t kept = from;
  for (std::size_t k = from; k < near.count; ++k) {
    const NodePair pair = near.pair[k];
    const TreeNode first{level, pair.first}, second{second_level, pair.second};
    if (left_out_.none_below(first, second)) {
      *to_far++ = pair;
      ++far.count;
    } else if (!left_out_(first, second)) {
      near.pair[kept++] = pair;
    }
  }
  near.count = kept;
}

// From the first nodes of all pairs to those of `level`, two below them.
template <typename Nodes, typename LeftOut>
void PairWalk<Nodes, LeftOut>::step_down(std::uint32_t level, const PairsByLevel& from, PairsByLevel& to,
                                         SearchCounts& counts) const {
  thread_local PairsByLevel waiting;
  to.clear(from.levels);
  waiting.clear(from.levels);
  const auto first = first_.level(level);
  const auto divide = [&](const auto& pairs_below, const PairList& pairs, std::size_t half, bool is_near) {
    if (pairs.count == 0) return;
    PairList& kept = is_near ? to.near[half] : to.far[half];
    PairList& split = is_near ? waiting.near[half] : waiting.far[half];
    const std::size_t kept_before = kept.count, split_before = split.count, room = 4 * pairs.count + 4;
    const auto second_level = static_cast<std::uint32_t>(2 * half);
    const Keep keep = half == 0 ? Keep::all : level == 0 ? Keep::none : Keep::level;
    NodePair* const to_kept = kept.room_for(room);
    NodePair* const to_split = split.room_for(room);
    SplitCounts found =
        pairs_below(first, second_.level(second_level), pairs.pair.data(), pairs.count, keep, to_kept, to_split);
    counts.boxes_tested += 4 * pairs.count;
    if constexpr (requires { first_.strips(level); }) {
      const Strip *const strips1 = first_.strips(level), *const strips2 = second_.strips(second_level);
      counts.boxes_tested += found.kept + found.split;
      found = {keep_near(strips1, strips2, to_kept, found.kept), keep_near(strips1, strips2, to_split, found.split)};
    }
    kept.count += found.kept;
    split.count += found.split;
    if (!is_near) return;
    drop_left_out(kept, kept_before, to.far[half], level, second_level);
    drop_left_out(split, split_before, waiting.far[half], level, second_level);
  };
  const auto below_first = [](auto... given) { return pairs_below_first(given...); };
  const auto below_second = [](auto... given) { return pairs_below_second(given...); };
  for (std::size_t half = 0; half < from.levels; ++half) {
    divide(below_first, from.near[half], half, true);
    divide(below_first, from.far[half], half, false);
  }
  for (std::size_t half = from.levels; half-- > 1;) {
    divide(below_second, waiting.near[half], half - 1, true);
    divide(below_second, waiting.far[half], half - 1, false);
  }
}

template <typename Nodes, typename LeftOut>
auto PairWalk<Nodes, LeftOut>::pairs_below(TreeNode top, std::uint32_t level, std::span<const TreeNode> list,
                                           std::size_t enough, SearchCounts& counts) const -> Below {
  thread_local std::array<PairsByLevel, 2> pairs;
  PairsByLevel *now = pairs.data(), *next = now + 1;
  std::size_t levels = 0;
  for (const TreeNode node : list) levels = std::max<std::size_t>(levels, node.level / 2 + 1);
  now->clear(levels);
  for (const TreeNode node : list) now->add(top, node, !left_out_.none_below(top, node));
  std::uint32_t here = top.level;
  do {
    here -= levels_at_once;
    step_down(here, *now, *next, counts);
    std::swap(now, next);
  } while (here > level && now->count() <= enough);
  return {here, *now};
}

template <typename Nodes, typename LeftOut>
std::uint32_t PairWalk<Nodes, LeftOut>::go_down(TreeNode top, std::uint32_t level, std::span<const TreeNode> list,
                                                std::size_t enough, MeetingLists& lists, SearchCounts& counts) const {
  const auto [here, pairs] = pairs_below(top, level, list, enough, counts);
  lists.sort_in(pairs, top.index << (top.level - here), std::size_t{1} << (top.level - here));
  return here;
}

}  // namespace lober::detail
