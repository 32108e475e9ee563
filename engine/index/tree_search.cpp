// Pairs of segments from two box trees walked against each other.
//
// The walk goes down the first tree in curve order and carries along the list of nodes of the second tree whose boxes
// meet the present one, always split to about its size. So everything found for a leaf is found together and comes
// out in curve order, which makes sorting the crossings nearly free.

#include <algorithm>
#include <vector>

#include "engine/index/index.hpp"
#include "engine/index/search.hpp"
#include "engine/memory.hpp"
#include "engine/parallel/parallel.hpp"

namespace lober {
namespace {

constexpr std::uint32_t block_level = 6;  // a block is a node of this level
static_assert(block_segments == leaf_size << block_level);

class TreeSearch {
 public:
  TreeSearch(const BoxTree& first, const BoxTree& second, bool self) : first_(first), second_(second), self_(self) {}

  // The nodes of the second tree that meet `node` of the first, out of those in `list`, split to the size of `node`.
  void keep_meeting(TreeNode node, std::span<const TreeNode> list, std::vector<TreeNode>& kept,
                    SearchCounts& counts) const {
    const Query query(first_, node);
    for (const TreeNode& candidate : list) keep_one(query, candidate, kept, counts);
  }

  void walk(TreeNode node, std::size_t list_begin, std::uint32_t block, std::vector<TreeNode>& stack,
            Buffer<SegmentPair>& pairs, PairConsumer& consumer, std::uint32_t& skip_before,
            SearchCounts& counts) const {
    const std::size_t list_end = stack.size();
    if (list_begin == list_end) return;
    if (static_cast<std::size_t>(node.index + 1) * (leaf_size << node.level) <= skip_before) return;
    if (node.level == 0) {
      leaf_pairs(node, std::span(stack).subspan(list_begin), pairs, counts);
      if (!pairs.empty()) {
        counts.pairs_proposed += pairs.size();
        skip_before = consumer.consume(block, pairs);
      }
      return;
    }
    for (std::uint32_t child = 2 * node.index; child < 2 * node.index + 2; ++child) {
      const TreeNode below{node.level - 1, child};
      if (child >= first_.nodes(below.level)) break;
      const Query query(first_, below);
      for (std::size_t k = list_begin; k < list_end; ++k) {
        const TreeNode candidate = stack[k];  // a copy: the stack moves when it grows
        keep_one(query, candidate, stack, counts);
      }
      walk(below, list_end, block, stack, pairs, consumer, skip_before, counts);
      stack.resize(list_end);
    }
  }

 private:
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

  // A node of the first tree, ready to be tested against many.
  struct Query {
    Query(const BoxTree& tree, TreeNode which) : node(which), box(tree.box(which)), extent(tree.box(which).extent()) {}
    TreeNode node;
    BoxQuery box;
    double extent;
  };

  void keep_one(const Query& query, TreeNode candidate, std::vector<TreeNode>& kept, SearchCounts& counts) const {
    ++counts.boxes_tested;
    const Box& other = second_.box(candidate);
    if (!meet(query.box, other)) return;
    if (self_ && apart(query.node, candidate)) return;
    if (candidate.level > 0 && (query.node.level == 0 || other.extent() > query.extent)) {
      const TreeNode left{candidate.level - 1, 2 * candidate.index};
      keep_one(query, left, kept, counts);
      if (left.index + 1 < second_.nodes(left.level)) keep_one(query, {left.level, left.index + 1}, kept, counts);
    } else {
      kept.push_back(candidate);
    }
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

  // Of the pairs of a leaf with itself, those with first < second.
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
};

// A node of the first tree with the nodes of the second that it meets.
struct Meeting {
  TreeNode node;
  std::vector<TreeNode> list;
};

// The upper part of the walk, from `from` down to `level`.
void collect(const TreeSearch& search, const BoxTree& first, const Meeting& from, std::uint32_t level,
             std::vector<Meeting>& collected, SearchCounts& counts) {
  if (from.list.empty()) return;
  if (from.node.level <= level) {
    collected.push_back(from);
    return;
  }
  for (std::uint32_t child = 2 * from.node.index; child < 2 * from.node.index + 2; ++child) {
    Meeting below{{from.node.level - 1, child}, {}};
    if (child >= first.nodes(below.node.level)) break;
    search.keep_meeting(below.node, from.list, below.list, counts);
    collect(search, first, below, level, collected, counts);
  }
}

SearchCounts search_trees(const BoxTree& first, const BoxTree& second, bool self, PairConsumer& consumer) {
  constexpr std::uint32_t task_level =
      block_level + 2;  // a task is four blocks: what lies above is walked by one thread
  const TreeSearch search(first, second, self);
  SearchCounts counts;
  Meeting root{first.root(), {}};
  search.keep_meeting(root.node, std::vector<TreeNode>{second.root()}, root.list, counts);
  std::vector<Meeting> tasks;
  collect(search, first, root, task_level, tasks, counts);

  std::vector<SearchCounts> task_counts(tasks.size());
  for_each_block(tasks.size(), 1, [&](std::size_t task, std::size_t) {
    SearchCounts& here = task_counts[task];
    std::vector<Meeting> blocks;
    collect(search, first, tasks[task], block_level, blocks, here);
    Buffer<SegmentPair> pairs;
    for (Meeting& block : blocks) {
      std::uint32_t skip_before = 0;
      search.walk(block.node, 0, block.node.index, block.list, pairs, consumer, skip_before, here);
      consumer.finish(block.node.index);
    }
    here.blocks_searched = blocks.size();
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

}  // namespace lober
