#include "engine/geometry/index/pair_walk.hpp"

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>

namespace lober::detail {

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

// Whether two nodes are so far from each other along the curve that there is nothing to ask between them, nor between
// any below them.
template <typename Nodes>
bool PairWalk<Nodes>::is_far(TreeNode first, TreeNode second) const {
  if (stalls_) return false;
  return !is_self_ || second.index << second.level >= far_behind(first, first);
}

// Whether there is nothing to find between two nodes, or one is a point that a curve stays in.
template <typename Nodes>
bool PairWalk<Nodes>::is_left_out(TreeNode first, TreeNode second) const {
  if (stalls_ && (is_point(first_.tree().box(first)) || is_point(second_.tree().box(second)))) return true;
  return is_self_ && nothing_between(tree_, first, second);
}

// Those of the pairs from number `from` on that are far go to `far`, and those that are left out go.
template <typename Nodes>
void PairWalk<Nodes>::drop_apart(PairList& near, std::size_t from, PairList& far, std::uint32_t level,
                                 std::uint32_t second_level) const {
  NodePair* to_far = far.room_for(near.count - from);
  std::size_t kept = from;
  for (std::size_t k = from; k < near.count; ++k) {
    const NodePair pair = near.pair[k];
    const TreeNode first{level, pair.first}, second{second_level, pair.second};
    if (is_far(first, second)) {
      *to_far++ = pair;
      ++far.count;
    } else if (!is_left_out(first, second)) {
      near.pair[kept++] = pair;
    }
  }
  near.count = kept;
}

// From the first nodes of all pairs to those of `level`, two below them.
template <typename Nodes>
void PairWalk<Nodes>::step_down(std::uint32_t level, const PairsByLevel& from, PairsByLevel& to,
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
    if constexpr (std::is_same_v<Nodes, NodeStrips>) {
      const Strip *const strips1 = first_.strips(level), *const strips2 = second_.strips(second_level);
      counts.boxes_tested += found.kept + found.split;
      found = {keep_near(strips1, strips2, to_kept, found.kept), keep_near(strips1, strips2, to_split, found.split)};
    }
    kept.count += found.kept;
    split.count += found.split;
    if (!is_near) return;
    drop_apart(kept, kept_before, to.far[half], level, second_level);
    drop_apart(split, split_before, waiting.far[half], level, second_level);
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

template <typename Nodes>
std::uint32_t PairWalk<Nodes>::go_down(TreeNode top, std::uint32_t level, std::span<const TreeNode> list,
                                       std::size_t enough, MeetingLists& lists, SearchCounts& counts) const {
  thread_local std::array<PairsByLevel, 2> pairs;
  PairsByLevel *now = pairs.data(), *next = now + 1;
  std::size_t levels = 0;
  for (const TreeNode node : list) levels = std::max<std::size_t>(levels, node.level / 2 + 1);
  now->clear(levels);
  for (const TreeNode node : list) now->add(top, node, !is_far(top, node));
  std::uint32_t here = top.level;
  do {
    here -= levels_at_once;
    step_down(here, *now, *next, counts);
    std::swap(now, next);
  } while (here > level && now->count() <= enough);
  const std::uint32_t begin = top.index << (top.level - here);
  lists.end_.assign(std::size_t{1} << (top.level - here), 0);
  now->for_each_list([&](const PairList& found, std::uint32_t) {
    for (std::size_t k = 0; k < found.count; ++k) ++lists.end_[found.pair[k].first - begin];
  });
  std::uint32_t total = 0;
  for (std::uint32_t& end : lists.end_) total += std::exchange(end, total);
  if (lists.met_.size() < total) lists.met_.resize(2 * std::size_t{total});
  now->for_each_list([&](const PairList& found, std::uint32_t second_level) {
    for (std::size_t k = 0; k < found.count; ++k) {
      const NodePair pair = found.pair[k];
      lists.met_[lists.end_[pair.first - begin]++] = {second_level, pair.second};
    }
  });
  return here;
}

template class PairWalk<NodeBoxes>;
template class PairWalk<NodeFrames>;
template class PairWalk<NodeStrips>;

}  // namespace lober::detail
