// Pairs of segments from two box trees walked against each other (pair_walk.hpp), in tasks: by boxes, or by what a few
// leaves show to be better where folds run side by side: slanted rectangles (node_frames.hpp), strips along parabolas
// for two curves (node_strips.hpp), windows for one that is folded upon itself many times (window_search.hpp).

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/index/index.hpp"
#include "engine/geometry/index/leaf_search.hpp"
#include "engine/geometry/index/node_frames.hpp"
#include "engine/geometry/index/node_strips.hpp"
#include "engine/geometry/index/pair_walk.hpp"
#include "engine/geometry/index/search.hpp"
#include "engine/geometry/index/window_search.hpp"

namespace lober::detail {
namespace {

constexpr std::uint32_t block_level = 6;  // a block is a node of this level
static_assert(block_segments == leaf_size << block_level);
constexpr std::uint32_t task_level = block_level + 2;  // a task is four blocks: what lies above is walked by one thread
static_assert(block_level % 2 == 0 && task_level % 2 == 0, "walks pass through even levels");

// The number of boxes a leaf from which on windows pay for one curve, strips for two: pairs of boxes between folds of
// one curve never cross, those of two curves may well. Making frames or strips takes as long as what they save of a
// number of boxes for each leaf.
constexpr double worth_windows = 250, worth_strips = 120, boxes_a_frame = 6.5, boxes_a_strip = 16;
// Strips of two curves stay if with them no more than this part of the boxes is tested: where bundles of folds lie
// across each other they tell nothing apart.
constexpr double part_with_strips = 0.4;

std::size_t blocks_of(const BoxTree& tree) {
  return tree.nodes(std::min(block_level, tree.levels() - 1));
}

// A node of the first tree with the nodes of the second that it meets.
struct Meeting {
  TreeNode node;
  std::vector<TreeNode> list;
};

constexpr std::size_t all_pairs = std::numeric_limits<std::size_t>::max();

// The nodes of a level, at or below another one, that meet anything.
template <typename Walk>
std::vector<Meeting> meetings_below(const Walk& walk, const Meeting& from, std::uint32_t level, SearchCounts& counts) {
  if (from.node.level <= level) return {from};
  MeetingLists lists;
  walk.go_down(from.node, level, from.list, all_pairs, lists, counts);
  std::vector<Meeting> met;
  const std::uint32_t begin = from.node.index << (from.node.level - level);
  for (std::uint32_t k = 0; k < lists.size(); ++k) {
    if (!lists[k].empty()) met.push_back({{level, begin + k}, {lists[k].begin(), lists[k].end()}});
  }
  return met;
}

// Number `index` of the nodes of the level of tasks with what it meets: the way down to it.
template <typename Walk>
Meeting task_below(const Walk& walk, Meeting from, std::size_t index, SearchCounts& counts) {
  MeetingLists lists;
  while (from.node.level > task_level) {
    const std::uint32_t level = from.node.level - levels_at_once;
    const auto number = static_cast<std::uint32_t>(index >> (level - task_level));
    walk.go_down(from.node, level, from.list, all_pairs, lists, counts);
    const auto list = lists[number - (from.node.index << levels_at_once)];
    from = {{level, number}, {list.begin(), list.end()}};
  }
  return from;
}

// How many boxes will be tested for a leaf, judged by a few, a small part of the walk, below some of the `tasks`
// meeting_of(0), meeting_of(1), ... Ends when it is certain to exceed `enough`.
template <typename Walk>
double boxes_a_leaf(const Walk& walk, std::size_t tasks, const auto& meeting_of, double enough, SearchCounts& counts) {
  if (tasks == 0) return 0;
  // Where tasks are few, a part of one block is enough.
  const std::uint32_t level = tasks < 4 ? block_level - levels_at_once : block_level;
  const std::size_t samples = std::clamp<std::size_t>(tasks / 4, 1, 8);
  std::size_t leaves = 0;
  double boxes = 0;
  const double ample = enough * static_cast<double>(samples << level);
  for (std::size_t k = 0; k < samples && boxes <= ample; ++k) {
    SearchCounts way, rest;
    const std::vector<Meeting> parts =
        meetings_below(walk, meeting_of((2 * k + 1) * tasks / (2 * samples)), level, way);
    counts += way;
    if (parts.empty()) continue;
    MeetingLists below;
    const Meeting& part = parts[parts.size() * ((5 * k + 4) % 8) / 8];  // another place in each
    walk.go_down(part.node, 0, part.list, pairs_at_once, below, rest);
    counts += rest;
    boxes += static_cast<double>(rest.boxes_tested) + static_cast<double>(way.boxes_tested >> (task_level - level));
    leaves += std::size_t{1} << level;
  }
  return leaves == 0 ? 0 : boxes / static_cast<double>(leaves);
}

// Whether the walk is to go by frames, with that number of boxes ahead.
bool worth_frames(const BoxTree& first, const BoxTree& second, double boxes) {
  const auto to_make = [](const BoxTree& tree) { return tree.frames() == nullptr ? tree.leaves() : 0; };
  const std::size_t frames = to_make(first) + (&first == &second ? 0 : to_make(second));
  if (!(boxes > boxes_a_frame * static_cast<double>(frames))) return false;
  return frames == 0 || (frames_are_small(first) && frames_are_small(second));
}

// The pairs of all leaves with those that are near.
SearchCounts search_leaves(const LeafSearch& search, const NearLeaves& near, const BoxTree& tree,
                           PairConsumer& consumer, SearchCounts counts) {
  const std::size_t leaves = tree.leaves();
  constexpr std::size_t in_block = std::size_t{1} << block_level;
  const std::size_t blocks = blocks_of(tree);
  std::vector<SearchCounts> block_counts(blocks);
  for_each_block(blocks, 1, [&](std::size_t block, std::size_t) {
    LeafSearch::Scratch scratch;
    const auto number = static_cast<std::uint32_t>(block);
    const std::size_t end = consumer.wants(number) ? std::min((block + 1) * in_block, leaves) : 0;
    std::array<std::uint32_t, in_block + 1> leaf;  // those that are near others, which may be few
    std::size_t count = 0;
    for (std::size_t k = block * in_block; k < end; ++k) {
      leaf[count] = static_cast<std::uint32_t>(k);
      count += near.of(leaf[count]).empty() ? 0 : 1;
    }
    for (std::size_t k = 0; k < count; ++k) {
      if (k + 1 < count) tree.prefetch_leaf(leaf[k + 1]);
      search.search(leaf[k], near.of(leaf[k]), number, consumer, scratch);
    }
    consumer.finish(number);
    block_counts[block] = scratch.counts;
  });
  for (const SearchCounts& block : block_counts) counts += block;
  counts.blocks_searched = blocks;
  return counts;
}

// The pairs of all leaves below a task.
template <typename Walk>
class TaskSearch {
 public:
  TaskSearch(const LeafSearch& search, const Walk& walk, PairConsumer& consumer)
      : search_(search), walk_(walk), consumer_(consumer) {}

  SearchCounts operator()(const Meeting& task) {
    go_down(task.node, task.list);
    leave_block();
    return scratch_.counts;
  }

 private:
  void go_down(TreeNode node, std::span<const TreeNode> list) {
    MeetingLists lists;
    const std::uint32_t level = walk_.go_down(node, 0, list, pairs_at_once, lists, scratch_.counts);
    const std::uint32_t begin = node.index << (node.level - level);
    for (std::uint32_t k = 0; k < lists.size(); ++k) {
      if (lists[k].empty()) continue;
      if (level == 0) {
        search_leaf(begin + k, lists[k]);
      } else if (level > block_level || consumer_.wants((begin + k) << level >> block_level)) {
        go_down({level, begin + k}, lists[k]);
      }
    }
  }
  void search_leaf(std::uint32_t leaf, std::span<const TreeNode> list) {
    const std::uint32_t block = leaf >> block_level;
    if (block != block_) {
      leave_block();
      block_ = block;
      scratch_.skip_before = 0;
    }
    if (consumer_.wants(block)) search_.search(leaf, list, block, consumer_, scratch_);
  }
  void leave_block() {
    if (block_ == no_block) return;
    consumer_.finish(block_);
    ++scratch_.counts.blocks_searched;
  }

  static constexpr std::uint32_t no_block = std::numeric_limits<std::uint32_t>::max();
  const LeafSearch& search_;
  const Walk& walk_;
  PairConsumer& consumer_;
  LeafSearch::Scratch scratch_;
  std::uint32_t block_ = no_block;
};

template <typename Walk>
SearchCounts search_tasks(const LeafSearch& search, const Walk& walk, std::span<const Meeting> tasks,
                          const BoxTree& first, PairConsumer& consumer, SearchCounts counts) {
  std::vector<SearchCounts> task_counts(tasks.size());
  for_each_block(tasks.size(), 1,
                 [&](std::size_t k, std::size_t) { task_counts[k] = TaskSearch(search, walk, consumer)(tasks[k]); });
  for (const SearchCounts& task : task_counts) counts += task;
  counts.blocks_skipped = blocks_of(first) - counts.blocks_searched;
  return counts;
}

// The first tree is not higher than a task: then lists of tasks take longer than the rest, and nothing but boxes pays.
SearchCounts search_small(const LeafSearch& search, const PairWalk<NodeBoxes>& by_boxes, const BoxTree& first,
                          const BoxTree& second, PairConsumer& consumer) {
  SearchCounts counts;
  ++counts.boxes_tested;
  if (!meet(first.box(), second.box())) {
    counts.blocks_skipped = blocks_of(first);
    return counts;
  }
  if (search.has_few_leaves()) {
    LeafSearch::Scratch scratch;
    if (consumer.wants(0)) search.search_few(consumer, scratch);
    consumer.finish(0);
    counts += scratch.counts;
    counts.blocks_searched = 1;
    return counts;
  }
  counts += TaskSearch(search, by_boxes, consumer)({top_of(first.levels()), roots_of(second.levels())});
  counts.blocks_skipped = blocks_of(first) - counts.blocks_searched;
  return counts;
}

SearchCounts search_self(const BoxTree& tree, PairConsumer& consumer) {
  const LeafSearch search(tree, tree, true);
  const NodeBoxes boxes(tree);
  const PairWalk<NodeBoxes> by_boxes(boxes);
  if (tree.root().level < task_level) return search_small(search, by_boxes, tree, tree, consumer);
  SearchCounts counts;
  const Meeting all{top_of(tree.levels()), roots_of(tree.levels())};
  // Where many boxes meet, the way down to all tasks is long.
  const auto task = [&](std::size_t index) { return task_below(by_boxes, all, index, counts); };
  const double a_leaf = boxes_a_leaf(by_boxes, tree.nodes(task_level), task, worth_windows, counts);
  if (a_leaf > worth_windows) {
    const NearLeaves near(tree, counts);
    if (near.is_complete()) return search_leaves(search, near, tree, consumer, counts);
  }
  if (worth_frames(tree, tree, a_leaf * static_cast<double>(tree.leaves()))) {
    const PairWalk<NodeFrames> by_frames(tree.make_frames());
    return search_tasks(search, by_frames, meetings_below(by_frames, all, task_level, counts), tree, consumer, counts);
  }
  return search_tasks(search, by_boxes, meetings_below(by_boxes, all, task_level, counts), tree, consumer, counts);
}

SearchCounts search_two(const BoxTree& first, const BoxTree& second, PairConsumer& consumer) {
  const LeafSearch search(first, second, false);
  const NodeBoxes boxes1(first), boxes2(second);
  const PairWalk<NodeBoxes> by_boxes(boxes1, boxes2);
  if (first.root().level < task_level) return search_small(search, by_boxes, first, second, consumer);
  SearchCounts counts;
  const std::vector<Meeting> tasks =
      meetings_below(by_boxes, {top_of(first.levels()), roots_of(second.levels())}, task_level, counts);
  const auto task = [&](std::size_t k) -> const Meeting& { return tasks[k]; };
  constexpr double no_bound = std::numeric_limits<double>::infinity();
  const double a_leaf = boxes_a_leaf(by_boxes, tasks.size(), task, no_bound, counts);
  const double boxes = a_leaf * static_cast<double>(std::min(first.leaves(), tasks.size() << task_level));
  if (a_leaf > worth_strips && boxes > boxes_a_strip * static_cast<double>(first.leaves() + second.leaves())) {
    const NodeStrips strips1(first), strips2(second);
    const PairWalk<NodeStrips> by_strips(strips1, strips2);
    if (boxes_a_leaf(by_strips, tasks.size(), task, no_bound, counts) <= part_with_strips * a_leaf) {
      return search_tasks(search, by_strips, tasks, first, consumer, counts);
    }
  }
  if (worth_frames(first, second, boxes)) {
    const PairWalk<NodeFrames> by_frames(first.make_frames(), second.make_frames());
    return search_tasks(search, by_frames, tasks, first, consumer, counts);
  }
  return search_tasks(search, by_boxes, tasks, first, consumer, counts);
}

}  // namespace

SearchCounts find_pairs_by_tree(const IndexedCurve& first, const IndexedCurve& second, PairConsumer& consumer) {
  return search_two(first.tree(), second.tree(), consumer);
}

SearchCounts find_self_pairs(const IndexedCurve& curve, PairConsumer& consumer) {
  return search_self(curve.tree(), consumer);
}

}  // namespace lober::detail
