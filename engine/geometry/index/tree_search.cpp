// Pairs of segments from two box trees walked against each other (tree_walk.hpp), in tasks, or what a few leaves show
// to be better where folds run side by side: a walk by slanted rectangles (frame_walk.hpp), strips along parabolas for
// two curves (node_strips.hpp), windows for one that is folded upon itself many times (window_search.hpp).

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/index/frame_walk.hpp"
#include "engine/geometry/index/index.hpp"
#include "engine/geometry/index/node_frames.hpp"
#include "engine/geometry/index/node_strips.hpp"
#include "engine/geometry/index/search.hpp"
#include "engine/geometry/index/tree_walk.hpp"
#include "engine/geometry/index/window_search.hpp"

namespace lober::detail {
namespace {

constexpr std::uint32_t block_level = 6;  // a block is a node of this level
static_assert(block_segments == leaf_size << block_level);
constexpr std::uint32_t task_level = block_level + 2;  // a task is four blocks: what lies above is walked by one thread
static_assert(block_level % 2 == 0, "the walk passes through even levels");

// The number of boxes a leaf from which on windows pay for one curve, strips for two: pairs of boxes between folds of
// one curve never cross, those of two curves may well. Making frames or strips takes as long as what they save of a
// number of boxes for each leaf.
constexpr double worth_windows = 250, worth_strips = 200, boxes_a_frame = 9, boxes_a_strip = 16;
// Strips of two curves stay if with them no more than this part of the boxes is tested: where bundles of folds lie
// across each other they tell nothing apart.
constexpr double part_with_strips = 0.4;

// A node of the first tree with the nodes of the second that it meets.
struct Meeting {
  TreeNode node;
  std::vector<TreeNode> list;
};

// The upper part of the walk, from `from` down to `level`.
void collect(const TreeWalk& search, const Meeting& from, std::uint32_t level, std::vector<Meeting>& collected,
             SearchCounts& counts) {
  if (from.list.empty()) return;
  if (from.node.level <= level) {
    collected.push_back(from);
    return;
  }
  TreeWalk::Carried carried;
  search.go_down(from.node, from.list, carried, counts);
  const TreeNode below = TreeWalk::first_below(from.node);
  for (std::size_t i = 0; i < search.nodes_below(from.node); ++i) {
    const TreeNode* list = carried.met[i].data();
    collect(search, {{below.level, below.index + static_cast<std::uint32_t>(i)}, {list, list + carried.count[i]}},
            level, collected, counts);
  }
}

// How many boxes will be tested for a leaf, judged by a few, a small part of the walk: from the tasks, or, before there
// are any, from the start of the walk, of which only some ways are followed. Ends when it is certain to exceed
// `enough`.
double boxes_a_leaf(const TreeWalk& search, std::size_t tasks, const auto& meeting_of, double enough,
                    SearchCounts& counts) {
  if (tasks == 0) return 0;
  // Where tasks are few, a part of one block is enough.
  const std::uint32_t level = tasks < 4 ? block_level - 2 : block_level;
  const std::size_t samples = std::clamp<std::size_t>(tasks / 4, 1, 8);
  SearchCounts sampled;
  std::size_t leaves = 0;
  const double ample = enough * static_cast<double>(samples << level);
  for (std::size_t k = 0; k < samples && static_cast<double>(sampled.boxes_tested) <= ample; ++k) {
    std::vector<Meeting> parts, met;
    collect(search, meeting_of((2 * k + 1) * tasks / (2 * samples)), level, parts, counts);
    if (parts.empty()) continue;
    collect(search, parts[parts.size() / 2], 0, met, sampled);
    leaves += std::size_t{1} << level;
  }
  counts.boxes_tested += sampled.boxes_tested;
  return leaves == 0 ? 0 : static_cast<double>(sampled.boxes_tested) / static_cast<double>(leaves);
}

// Whether the walk is to go by frames, with that number of boxes ahead.
bool worth_frames(const BoxTree& first, const BoxTree& second, double boxes) {
  const auto to_make = [](const BoxTree& tree) { return tree.frames() == nullptr ? tree.leaves() : 0; };
  const std::size_t frames = to_make(first) + (&first == &second ? 0 : to_make(second));
  if (!(boxes > boxes_a_frame * static_cast<double>(frames))) return false;
  return frames == 0 || (frames_are_small(first) && frames_are_small(second));
}

// The node `index` of the level of tasks with what it meets: the way down to it from the root.
Meeting task_below(const TreeWalk& search, Meeting from, std::size_t index, SearchCounts& counts) {
  while (from.node.level > task_level && !from.list.empty()) {
    TreeWalk::Carried carried;
    search.go_down(from.node, from.list, carried, counts);
    const TreeNode below = TreeWalk::first_below(from.node);
    const auto number = static_cast<std::uint32_t>(index >> (below.level - task_level));
    const std::size_t i = number - below.index;
    const TreeNode* const list = carried.met[i].data();
    from = {{below.level, number}, {list, list + carried.count[i]}};
  }
  return from;
}

// The pairs of all leaves with those that are near.
SearchCounts search_leaves(const TreeWalk& search, const NearLeaves& near, const BoxTree& tree, PairConsumer& consumer,
                           SearchCounts counts) {
  const std::size_t leaves = tree.leaves();
  constexpr std::size_t in_block = std::size_t{1} << block_level;
  const std::size_t blocks = (leaves + in_block - 1) / in_block;
  std::vector<SearchCounts> block_counts(blocks);
  for_each_block(blocks, 1, [&](std::size_t block, std::size_t) {
    TreeWalk::Scratch scratch(0);
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
      search.walk({0, leaf[k]}, near.of(leaf[k]), number, consumer, scratch);
    }
    consumer.finish(number);
    block_counts[block] = scratch.counts;
  });
  for (const SearchCounts& block : block_counts) counts += block;
  counts.blocks_searched = blocks;
  return counts;
}

// The same list with nodes of even levels, the ones that have frames: others are replaced by those below them.
std::vector<TreeNode> on_even_levels(const BoxTree& tree, std::span<const TreeNode> list) {
  std::vector<TreeNode> even;
  even.reserve(2 * list.size());
  for (const TreeNode node : list) {
    if (node.level % levels_at_once == 0) {
      even.push_back(node);
      continue;
    }
    const TreeNode first{node.level - 1, 2 * node.index};
    even.push_back(first);
    if (first.index + 1 < tree.nodes(first.level)) even.push_back({first.level, first.index + 1});
  }
  return even;
}

// From what the root meets, by frames instead of boxes.
SearchCounts search_by_frames(const TreeWalk& search, const BoxTree& tree, const BoxTree& second,
                              std::span<const TreeNode> list, PairConsumer& consumer, SearchCounts counts) {
  const FrameWalk walk(tree.make_frames(), second.make_frames());
  const std::uint32_t root_level = tree.root().level;
  MeetingLists tasks;
  walk.go_down({root_level + root_level % 2, 0}, task_level, on_even_levels(second, list), tasks, counts);
  std::vector<SearchCounts> task_counts(tasks.size());
  for_each_block(tasks.size(), 1, [&](std::size_t number, std::size_t) {
    const auto task = static_cast<std::uint32_t>(number);
    if (tasks[task].empty()) return;
    MeetingLists leaves;
    TreeWalk::Scratch scratch(0);
    walk.go_down({task_level, task}, 0, tasks[task], leaves, scratch.counts);
    constexpr std::uint32_t in_block = 1U << block_level;
    for (std::uint32_t first = 0; first < leaves.size(); first += in_block) {
      const std::uint32_t begin = (task << task_level) + first, block = begin >> block_level;
      if (begin >= tree.leaves()) break;
      scratch.skip_before = 0;
      for (std::uint32_t k = 0; k < in_block && consumer.wants(block); ++k) {
        search.walk({0, begin + k}, leaves[first + k], block, consumer, scratch);
      }
      consumer.finish(block);
      ++scratch.counts.blocks_searched;
    }
    task_counts[task] = scratch.counts;
  });
  for (const SearchCounts& task : task_counts) counts += task;
  counts.blocks_skipped = tree.nodes(block_level) - counts.blocks_searched;
  return counts;
}

// The walk of a first tree that is one block: the curves are small, and then lists of tasks take longer than the rest.
SearchCounts search_block(const TreeWalk& search, TreeNode root, SearchCounts counts, const std::vector<TreeNode>& list,
                          PairConsumer& consumer) {
  if (list.empty()) {
    counts.blocks_skipped = 1;
    return counts;
  }
  TreeWalk::Scratch scratch(root.level);
  if (consumer.wants(0)) search.walk(root, list, 0, consumer, scratch);
  consumer.finish(0);
  counts += scratch.counts;
  counts.blocks_searched = 1;
  return counts;
}

SearchCounts search_few(const TreeWalk& search, const BoxTree& first, const BoxTree& second, PairConsumer& consumer) {
  TreeWalk::Scratch scratch(0);
  scratch.counts.boxes_tested = 1;
  if (!meet(first.box(), second.box())) {
    scratch.counts.blocks_skipped = 1;
    return scratch.counts;
  }
  if (consumer.wants(0)) search.walk_few(consumer, scratch);
  consumer.finish(0);
  scratch.counts.blocks_searched = 1;
  return scratch.counts;
}

SearchCounts search_trees(const BoxTree& first, const BoxTree& second, bool self, PairConsumer& consumer) {
  TreeWalk search(first, second, self);
  if (search.has_few_leaves()) return search_few(search, first, second, consumer);
  SearchCounts counts;
  std::vector<TreeNode> list = search.start(counts);
  if (first.root().level <= block_level) return search_block(search, first.root(), counts, list, consumer);
  Meeting start{first.root(), std::move(list)};
  std::vector<Meeting> tasks;
  const auto task_at = [&](std::size_t k) { return tasks[k]; };
  const bool is_small = start.node.level < task_level;  // too small for any other way to pay
  constexpr double no_bound = std::numeric_limits<double>::infinity();
  double a_leaf = 0;
  std::size_t leaves = first.leaves();
  if (self) {
    // Where many boxes meet, the way down to the tasks is long.
    const auto task = [&](std::size_t index) { return task_below(search, start, index, counts); };
    a_leaf = boxes_a_leaf(search, is_small ? 0 : first.nodes(task_level), task, worth_windows, counts);
    if (a_leaf > worth_windows) {
      const NearLeaves near(first, counts);
      if (near.is_complete()) return search_leaves(search, near, first, consumer, counts);
    }
  } else {
    collect(search, start, task_level, tasks, counts);
    a_leaf = boxes_a_leaf(search, is_small ? 0 : tasks.size(), task_at, no_bound, counts);
    leaves = std::min(leaves, tasks.size() << task_level);
  }
  const double boxes = a_leaf * static_cast<double>(leaves);
  std::optional<NodeStrips> strips1, strips2;
  if (!self && a_leaf > worth_strips && boxes > boxes_a_strip * static_cast<double>(first.leaves() + second.leaves())) {
    search.use(strips1.emplace(first), strips2.emplace(second));
    const double with_strips = boxes_a_leaf(search, tasks.size(), task_at, no_bound, counts);
    if (with_strips > part_with_strips * a_leaf) search.use_boxes_only();
  }
  if (!search.uses_strips() && worth_frames(first, second, boxes)) {
    return search_by_frames(search, first, second, start.list, consumer, counts);
  }
  if (self) collect(search, start, task_level, tasks, counts);
  std::vector<SearchCounts> task_counts(tasks.size());
  for_each_block(tasks.size(), 1, [&](std::size_t task, std::size_t) {
    std::vector<Meeting> blocks;
    TreeWalk::Scratch scratch(block_level);
    collect(search, tasks[task], block_level, blocks, scratch.counts);
    for (Meeting& block : blocks) {
      scratch.skip_before = 0;
      if (consumer.wants(block.node.index)) search.walk(block.node, block.list, block.node.index, consumer, scratch);
      consumer.finish(block.node.index);
    }
    scratch.counts.blocks_searched = blocks.size();
    task_counts[task] = scratch.counts;
  });
  for (const SearchCounts& task : task_counts) counts += task;
  counts.blocks_skipped = first.nodes(std::min(block_level, first.levels() - 1)) - counts.blocks_searched;
  return counts;
}

}  // namespace

SearchCounts find_pairs_by_tree(const IndexedCurve& first, const IndexedCurve& second, PairConsumer& consumer) {
  return search_trees(first.tree(), second.tree(), false, consumer);
}

SearchCounts find_self_pairs(const IndexedCurve& curve, PairConsumer& consumer) {
  return search_trees(curve.tree(), curve.tree(), true, consumer);
}

}  // namespace lober::detail
