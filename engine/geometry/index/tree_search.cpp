// Pairs of segments from two box trees walked against each other.
//
// The walk goes down the first tree in curve order and carries along the list of nodes of the second tree whose boxes
// meet the present one, always split to about its size. So everything found for a leaf is found together and comes
// out in curve order, which makes sorting the crossings nearly free. Where folds run side by side, nodes are held
// against each other by slanted rectangles (node_frames.hpp) or by strips along parabolas (node_strips.hpp) too, and
// one curve that is folded upon itself many times is searched window by window (window_search.hpp).

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/index/index.hpp"
#include "engine/geometry/index/node_frames.hpp"
#include "engine/geometry/index/node_strips.hpp"
#include "engine/geometry/index/search.hpp"
#include "engine/geometry/index/window_search.hpp"
#include "kernels/box_pyramid.hpp"
#include "lober/base/buffer.hpp"

namespace lober::detail {
namespace {

constexpr std::uint32_t block_level = 6;  // a block is a node of this level
static_assert(block_segments == leaf_size << block_level);
constexpr std::uint32_t task_level = block_level + 2;  // a task is four blocks: what lies above is walked by one thread
static_assert(block_level % 2 == 0, "the walk passes through even levels");

// The number of boxes a leaf from which on frames and windows pay for one curve, strips for two: pairs of boxes between
// folds of one curve never cross, those of two curves may well. Making strips takes as long as testing a number of
// boxes for each leaf.
constexpr double worth_frames = 16, worth_windows = 350, worth_strips = 200, boxes_a_strip = 16;
// Strips of two curves stay if with them no more than this part of the boxes is tested: where bundles of folds lie
// across each other they tell nothing apart.
constexpr double part_with_strips = 0.4;

// The nodes of the second tree that are carried along, for each of the nodes below one node of the first.
struct Carried {
  std::array<Buffer<TreeNode>, nodes_at_once> met;
  std::array<std::size_t, nodes_at_once> count{};
};

class TreeSearch {
 public:
  TreeSearch(const BoxTree& first, const BoxTree& second, bool self) : first_(first), second_(second), self_(self) {}

  // Where the walk starts: the root of the first tree with what it meets.
  [[nodiscard]] std::vector<TreeNode> start(SearchCounts& counts) const {
    ++counts.boxes_tested;
    if (!meet(first_.box(), second_.box())) return {};
    Buffer<TreeNode> list{second_.root()};
    std::size_t count = 1;
    split_to_size(first_.root(), list, count, counts);
    return {list.begin(), list.begin() + static_cast<std::ptrdiff_t>(count)};
  }

  // Levels from a node to those that the walk goes on to: two, one where that makes the level even.
  [[nodiscard]] static std::uint32_t step_from(std::uint32_t level) { return level % 2 == 1 ? 1 : levels_at_once; }

  // For each node below `node` of the first tree the nodes of the second that meet it, out of those in `list`, split to
  // about its size.
  void go_down(TreeNode node, std::span<const TreeNode> list, Carried& carried, SearchCounts& counts) const {
    const TreeNode below = first_below(node);
    const std::size_t present = nodes_below(node);
    std::array<TreeNode*, nodes_at_once> met{};
    for (std::size_t i = 0; i < nodes_at_once; ++i) {
      ensure_size(carried.met[i], list.size() + 1);
      met[i] = carried.met[i].data();
    }
    distribute(&first_.box(below), present, second_.pyramid(), list.data(), list.size(), met, carried.count);
    counts.boxes_tested += present * list.size();
    for (std::size_t i = 0; i < present; ++i) {
      const TreeNode child{below.level, below.index + static_cast<std::uint32_t>(i)};
      if (self_) drop_apart(child, carried.met[i], carried.count[i]);
      drop_beside(child, carried.met[i], carried.count[i], counts);
      if (carried.count[i] > 0) split_to_size(child, carried.met[i], carried.count[i], counts);
    }
  }

  [[nodiscard]] static TreeNode first_below(TreeNode node) {
    const std::uint32_t step = step_from(node.level);
    return {node.level - step, node.index << step};
  }
  [[nodiscard]] std::size_t nodes_below(TreeNode node) const {
    const TreeNode below = first_below(node);
    return std::min<std::size_t>(std::size_t{1} << step_from(node.level), first_.nodes(below.level) - below.index);
  }

  struct Scratch {
    explicit Scratch(std::uint32_t level) : carried((level + 1) / levels_at_once + 1) {}
    std::vector<Carried> carried;  // one for each level that the walk passes through
    Buffer<SegmentPair> pairs;
    std::uint32_t skip_before = 0;
    SearchCounts counts;
  };

  void walk(TreeNode node, std::span<const TreeNode> list, std::uint32_t block, PairConsumer& consumer,
            Scratch& scratch) const {
    if (list.empty()) return;
    if (static_cast<std::size_t>(node.index + 1) * (leaf_size << node.level) <= scratch.skip_before) return;
    if (node.level == 0) {
      leaf_pairs(node, list, scratch.pairs, scratch.counts);
      if (!scratch.pairs.empty()) {
        scratch.counts.pairs_proposed += scratch.pairs.size();
        scratch.skip_before = consumer.consume(block, scratch.pairs);
      }
      return;
    }
    Carried& carried = scratch.carried[(node.level + 1) / levels_at_once];
    go_down(node, list, carried, scratch.counts);
    const TreeNode below = first_below(node);
    for (std::size_t i = 0; i < nodes_below(node); ++i) {
      walk({below.level, below.index + static_cast<std::uint32_t>(i)}, {carried.met[i].data(), carried.count[i]}, block,
           consumer, scratch);
    }
  }

  // Uses the frames from now on, for a curve with itself. They must outlive the search.
  void use(const NodeFrames& frames) { frames_ = &frames; }
  // Uses the strips of two curves.
  void use(const NodeStrips& first, const NodeStrips& second) {
    strips1_ = &first;
    strips2_ = &second;
  }
  void use_boxes_only() { strips1_ = strips2_ = nullptr; }

 private:
  void drop_beside(TreeNode node, Buffer<TreeNode>& list, std::size_t& count, SearchCounts& counts) const {
    if (frames_ == nullptr && strips1_ == nullptr) return;
    counts.boxes_tested += count;
    count = frames_ != nullptr ? keep_near(frames_->of(node), frames_->pyramid(), list.data(), count)
                               : keep_near(strips1_->of(node), strips2_->pyramid(), list.data(), count);
  }

  static void ensure_size(Buffer<TreeNode>& buffer, std::size_t size) {
    if (buffer.size() < size) buffer.resize(2 * size);
  }

  void drop_apart(TreeNode node, Buffer<TreeNode>& list, std::size_t& count) const {
    const auto end = std::remove_if(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(count),
                                    [&](TreeNode candidate) { return apart(node, candidate); });
    count = static_cast<std::size_t>(end - list.begin());
  }

  // Replaces nodes of the second tree that are larger than `node` of the first by those below them that meet it; at a
  // leaf, down to the leaves.
  void split_to_size(TreeNode node, Buffer<TreeNode>& list, std::size_t& count, SearchCounts& counts) const {
    const Box& box = first_.box(node);
    const double largest = node.level == 0 ? -1 : box.extent();
    thread_local Buffer<TreeNode> waiting, split;
    std::size_t kept = 0, waiting_count = count;
    ensure_size(waiting, count);
    std::copy_n(list.begin(), count, waiting.begin());
    while (waiting_count > 0) {
      ensure_size(list, kept + waiting_count + 1);
      ensure_size(split, nodes_at_once * waiting_count + 1);
      const SplitCounts refined =
          refine(box, largest, second_.pyramid(), waiting.data(), waiting_count, &list[kept], split.data());
      counts.boxes_tested += nodes_at_once * (waiting_count - refined.kept);
      kept += refined.kept;
      waiting.swap(split);
      waiting_count = refined.split;
      if (self_) drop_apart(node, waiting, waiting_count);
      drop_beside(node, waiting, waiting_count, counts);
    }
    count = kept;
  }

  // In a search of a curve against itself: nothing to find between these two nodes.
  [[nodiscard]] bool apart(TreeNode node, TreeNode candidate) const {
    const std::uint32_t begin = node.index << node.level, end = (node.index + 1) << node.level;
    const std::uint32_t other_begin = candidate.index << candidate.level;
    const std::uint32_t other_end = (candidate.index + 1) << candidate.level;
    if (other_end <= begin) return true;  // the pair is found the other way round
    const std::uint8_t common = first_.flags(node) & second_.flags(candidate);
    if (common == 0) return false;
    if (other_begin < end) return true;  // one contains the other, and the larger is one monotone run
    const bool wraps = begin == 0 && other_end >= second_.leaves() && second_.curve().closed;
    return other_begin == end || wraps;
  }

  void leaf_pairs(TreeNode leaf, std::span<const TreeNode> others, Buffer<SegmentPair>& pairs,
                  SearchCounts& counts) const {
    SegmentBoxes boxes;
    segment_boxes(first_.leaf_points(leaf.index), boxes);
    const auto begin = static_cast<std::uint32_t>(leaf.index * leaf_size);
    pairs.clear();
    for (const TreeNode& other : others) {
      const std::size_t before = pairs.size();
      pairs.resize(before + leaf_size * leaf_size);
      const auto other_begin = static_cast<std::uint32_t>(other.index * leaf_size);
      std::size_t found = meeting_segments(boxes, begin, second_.leaf_points(other.index), second_.box(other),
                                           other_begin, pairs.data() + before);
      if (self_ && other.index == leaf.index) found = keep_upper(pairs.data() + before, found);
      pairs.resize(before + found);
    }
    drop_padding(pairs);
    counts.boxes_tested += others.size();
  }

  // Keeps those pairs of a leaf with itself that have first < second.
  static std::size_t keep_upper(SegmentPair* pairs, std::size_t count) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < count; ++k) {
      if (pairs[k].first < pairs[k].second) pairs[kept++] = pairs[k];
    }
    return kept;
  }

  // The last leaf is filled up with segments of no length that are not there.
  void drop_padding(Buffer<SegmentPair>& pairs) const {
    const std::size_t first_count = first_.segments(), second_count = second_.segments();
    std::erase_if(pairs,
                  [&](const SegmentPair& pair) { return pair.first >= first_count || pair.second >= second_count; });
  }

  const BoxTree& first_;
  const BoxTree& second_;
  bool self_;
  const NodeFrames* frames_ = nullptr;
  const NodeStrips* strips1_ = nullptr;
  const NodeStrips* strips2_ = nullptr;
};

// A node of the first tree with the nodes of the second that it meets.
struct Meeting {
  TreeNode node;
  std::vector<TreeNode> list;
};

// The upper part of the walk, from `from` down to `level`.
void collect(const TreeSearch& search, const Meeting& from, std::uint32_t level, std::vector<Meeting>& collected,
             SearchCounts& counts) {
  if (from.list.empty()) return;
  if (from.node.level <= level) {
    collected.push_back(from);
    return;
  }
  Carried carried;
  search.go_down(from.node, from.list, carried, counts);
  const TreeNode below = TreeSearch::first_below(from.node);
  for (std::size_t i = 0; i < search.nodes_below(from.node); ++i) {
    const TreeNode* list = carried.met[i].data();
    collect(search, {{below.level, below.index + static_cast<std::uint32_t>(i)}, {list, list + carried.count[i]}},
            level, collected, counts);
  }
}

// The work ahead of the walk, judged by a few leaves, a small part of it.
struct Forecast {
  double boxes_a_leaf = 0, boxes = 0;
};
Forecast forecast(const TreeSearch& search, const std::vector<Meeting>& tasks, SearchCounts& counts) {
  const std::size_t samples = std::min<std::size_t>(4, tasks.size() / 4);
  SearchCounts sampled;
  std::size_t leaves = 0;
  for (std::size_t k = 0; k < samples; ++k) {
    const Meeting& task = tasks[(2 * k + 1) * tasks.size() / (2 * samples)];
    std::vector<Meeting> blocks, met;
    collect(search, task, block_level, blocks, sampled);
    if (blocks.empty()) continue;
    collect(search, blocks[blocks.size() / 2], 0, met, sampled);
    leaves += std::size_t{1} << block_level;
  }
  if (leaves == 0) return {};
  counts.boxes_tested += sampled.boxes_tested;
  const double a_leaf = static_cast<double>(sampled.boxes_tested) / static_cast<double>(leaves);
  return {a_leaf, a_leaf * static_cast<double>(tasks.size() << task_level)};
}

// The pairs of all leaves with those that are near.
SearchCounts search_leaves(const TreeSearch& search, const NearLeaves& near, std::size_t leaves, PairConsumer& consumer,
                           SearchCounts counts) {
  constexpr std::size_t in_block = std::size_t{1} << block_level;
  const std::size_t blocks = (leaves + in_block - 1) / in_block;
  std::vector<SearchCounts> block_counts(blocks);
  for_each_block(blocks, 1, [&](std::size_t block, std::size_t) {
    TreeSearch::Scratch scratch(0);
    const auto number = static_cast<std::uint32_t>(block);
    const std::size_t end = consumer.wants(number) ? std::min((block + 1) * in_block, leaves) : 0;
    for (std::size_t leaf = block * in_block; leaf < end; ++leaf) {
      const auto index = static_cast<std::uint32_t>(leaf);
      search.walk({0, index}, near.of(index), number, consumer, scratch);
    }
    consumer.finish(number);
    block_counts[block] = scratch.counts;
  });
  for (const SearchCounts& block : block_counts) counts += block;
  counts.blocks_searched = blocks;
  return counts;
}

// The walk of a first tree that is one block: the curves are small, and then lists of tasks take longer than the rest.
SearchCounts search_block(const TreeSearch& search, TreeNode root, SearchCounts counts,
                          const std::vector<TreeNode>& list, PairConsumer& consumer) {
  if (list.empty()) {
    counts.blocks_skipped = 1;
    return counts;
  }
  TreeSearch::Scratch scratch(root.level);
  if (consumer.wants(0)) search.walk(root, list, 0, consumer, scratch);
  consumer.finish(0);
  counts += scratch.counts;
  counts.blocks_searched = 1;
  return counts;
}

SearchCounts search_trees(const BoxTree& first, const BoxTree& second, bool self, PairConsumer& consumer) {
  TreeSearch search(first, second, self);
  SearchCounts counts;
  std::vector<TreeNode> list = search.start(counts);
  if (first.root().level <= block_level) return search_block(search, first.root(), counts, list, consumer);
  std::vector<Meeting> tasks;
  collect(search, {first.root(), std::move(list)}, task_level, tasks, counts);

  const Forecast ahead = forecast(search, tasks, counts);
  if (self && ahead.boxes_a_leaf > worth_windows) {
    const NearLeaves near(first, counts);
    if (near.is_complete()) return search_leaves(search, near, first.leaves(), consumer, counts);
  }
  std::optional<NodeFrames> frames;
  std::optional<NodeStrips> strips1, strips2;
  if (self && ahead.boxes_a_leaf > worth_frames) {
    search.use(frames.emplace(first));
  } else if (ahead.boxes_a_leaf > worth_strips &&
             ahead.boxes > boxes_a_strip * static_cast<double>(first.leaves() + second.leaves())) {
    search.use(strips1.emplace(first), strips2.emplace(second));
    const Forecast with_strips = forecast(search, tasks, counts);
    if (with_strips.boxes_a_leaf > part_with_strips * ahead.boxes_a_leaf) search.use_boxes_only();
  }
  std::vector<SearchCounts> task_counts(tasks.size());
  for_each_block(tasks.size(), 1, [&](std::size_t task, std::size_t) {
    std::vector<Meeting> blocks;
    TreeSearch::Scratch scratch(block_level);
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
