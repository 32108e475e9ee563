// The walk of one box tree against another (private to index/).
//
// It goes down the first tree in curve order and carries along the list of nodes of the second tree whose boxes meet
// the present one, always split to about its size. So everything found for a leaf is found together and comes out in
// curve order, which makes sorting the crossings nearly free.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "engine/geometry/index/box_tree.hpp"
#include "engine/geometry/index/index.hpp"
#include "engine/geometry/index/leaf_turns.hpp"
#include "engine/geometry/index/node_strips.hpp"
#include "kernels/bent_slab.hpp"
#include "kernels/box_pyramid.hpp"
#include "lober/base/buffer.hpp"

namespace lober::detail {

class TreeWalk {
 public:
  /// The nodes of the second tree that are carried along, for each of the nodes below one node of the first.
  struct Carried {
    std::array<Buffer<TreeNode>, nodes_at_once> met;
    std::array<std::size_t, nodes_at_once> count{};
  };

  /// With `self` the two trees are one.
  TreeWalk(const BoxTree& first, const BoxTree& second, bool self)
      : first_(first),
        second_(second),
        self_(self),
        stalls_(first.stalls() || second.stalls()),
        tree_(first.as_self()) {}

  /// Where the walk starts: the root of the first tree with what it meets.
  [[nodiscard]] std::vector<TreeNode> start(SearchCounts& counts) const {
    ++counts.boxes_tested;
    if (!meet(first_.box(), second_.box())) return {};
    Buffer<TreeNode> list{second_.root()};
    std::size_t count = 1;
    split_to_size(first_.root(), list, count, counts);
    return {list.begin(), list.begin() + static_cast<std::ptrdiff_t>(count)};
  }

  /// Levels from a node to those that the walk goes on to: two, one where that makes the level even.
  [[nodiscard]] static std::uint32_t step_from(std::uint32_t level) { return level % 2 == 1 ? 1 : levels_at_once; }

  /// For each node below `node` of the first tree the nodes of the second that meet it, out of those in `list`, split
  /// to about its size.
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
      if (self_) carried.count[i] = drop_apart(child, carried.met[i].data(), carried.count[i]);
      drop_beside(child, carried.met[i], carried.count[i], counts);
      if (carried.count[i] > 0) split_to_size(child, carried.met[i], carried.count[i], counts);
    }
  }

  /// The first of the nodes that the walk goes on to from `node`, and how many they are.
  [[nodiscard]] static TreeNode first_below(TreeNode node) {
    const std::uint32_t step = step_from(node.level);
    return {node.level - step, node.index << step};
  }
  [[nodiscard]] std::size_t nodes_below(TreeNode node) const {
    const TreeNode below = first_below(node);
    return std::min<std::size_t>(std::size_t{1} << step_from(node.level), first_.nodes(below.level) - below.index);
  }

  /// Memory of a walk from a node of `level`, what it counts, and the segment of the first curve before which nothing
  /// is wanted any more.
  struct Scratch {
    explicit Scratch(std::uint32_t level) : carried(level == 0 ? 0 : (level + 1) / levels_at_once + 1) {}
    std::vector<Carried> carried;  // one for each level that the walk passes through
    Buffer<SegmentPair> pairs;
    std::uint32_t skip_before = 0;
    SearchCounts counts;
  };

  /// Hands the pairs of all leaves below `node`, which meets the nodes of `list`, to the consumer.
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

  /// Whether the trees have so few leaves that levels above them save nothing.
  [[nodiscard]] bool has_few_leaves() const {
    return !self_ && !stalls_ && std::max(first_.leaves(), second_.leaves()) <= few_leaves;
  }
  /// Hands the pairs of all leaves of two such trees to the consumer, as one block: those of the first tree, four at a
  /// time, are held against all of the second that meet its box.
  void walk_few(PairConsumer& consumer, Scratch& scratch) const {
    std::array<TreeNode, few_leaves> list;
    std::array<std::array<TreeNode, few_leaves + 1>, nodes_at_once> near;
    std::array<TreeNode*, nodes_at_once> met{};
    for (std::size_t i = 0; i < nodes_at_once; ++i) met[i] = near[i].data();
    const BoxQuery query(first_.box());
    std::size_t size = 0;
    for (std::uint32_t leaf = 0; leaf < second_.leaves(); ++leaf) {
      list[size] = {0, leaf};
      size += static_cast<std::size_t>(meet(query, second_.leaf_boxes()[leaf]));
    }
    scratch.counts.boxes_tested += second_.leaves();
    for (std::size_t begin = 0; begin < first_.leaves(); begin += nodes_at_once) {
      const std::size_t present = std::min(nodes_at_once, first_.leaves() - begin);
      std::array<std::size_t, nodes_at_once> count{};
      distribute(first_.leaf_boxes() + begin, present, second_.pyramid(), list.data(), size, met, count);
      scratch.counts.boxes_tested += present * size;
      for (std::size_t i = 0; i < present; ++i) {
        walk({0, static_cast<std::uint32_t>(begin + i)}, {near[i].data(), count[i]}, 0, consumer, scratch);
      }
    }
  }

  /// Uses the strips of two curves.
  void use(const NodeStrips& first, const NodeStrips& second) {
    strips1_ = &first;
    strips2_ = &second;
  }
  [[nodiscard]] bool uses_strips() const { return strips1_ != nullptr; }
  /// Neither of them.
  void use_boxes_only() { strips1_ = strips2_ = nullptr; }

 private:
  static constexpr std::size_t few_leaves = 32;

  void drop_beside(TreeNode node, Buffer<TreeNode>& list, std::size_t& count, SearchCounts& counts) const {
    if (strips1_ == nullptr) return;
    counts.boxes_tested += count;
    count = keep_near(strips1_->of(node), strips2_->pyramid(), list.data(), count);
  }

  static void ensure_size(Buffer<TreeNode>& buffer, std::size_t size) {
    if (buffer.size() < size) buffer.resize(2 * size);
  }

  [[nodiscard]] std::size_t drop_apart(TreeNode node, TreeNode* list, std::size_t count) const {
    // Most are far along the curve, where there is nothing to ask.
    const std::uint32_t far = far_behind(node, node);
    std::size_t kept = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const TreeNode candidate = list[k];
      list[kept] = candidate;
      kept += static_cast<std::size_t>(candidate.index << candidate.level >= far ||
                                       !nothing_between(tree_, node, candidate));
    }
    return kept;
  }

  void drop_points(TreeNode node, Buffer<TreeNode>& list, std::size_t& count) const {
    const auto end = is_point(first_.box(node))
                         ? list.begin()
                         : std::remove_if(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(count),
                                          [&](TreeNode candidate) { return is_point(second_.box(candidate)); });
    count = static_cast<std::size_t>(end - list.begin());
  }

  // Replaces nodes of the second tree that are larger than `node` of the first by those below them that meet it; at a
  // leaf, down to the leaves.
  void split_to_size(TreeNode node, Buffer<TreeNode>& list, std::size_t& count, SearchCounts& counts) const {
    const Box& box = first_.box(node);
    const double largest = node.level == 0 ? -1 : box.extent();
    if (stalls_) drop_points(node, list, count);
    thread_local Buffer<TreeNode> waiting, below;
    std::size_t kept = 0, waiting_count = count;
    ensure_size(waiting, count);
    std::copy_n(list.begin(), count, waiting.begin());
    while (waiting_count > 0) {
      ensure_size(list, kept + nodes_at_once * waiting_count + 1);
      ensure_size(below, nodes_at_once * waiting_count + 1);
      SplitCounts done =
          refine(box, largest, second_.pyramid(), waiting.data(), waiting_count, &list[kept], below.data());
      counts.boxes_tested += nodes_at_once * (waiting_count - done.kept);
      if (self_) done.split = drop_apart(node, below.data(), done.split);
      kept += done.kept;
      waiting.swap(below);
      waiting_count = done.split;
      if (stalls_) drop_points(node, waiting, waiting_count);
      drop_beside(node, waiting, waiting_count, counts);
    }
    count = kept;
  }

  void leaf_pairs(TreeNode leaf, std::span<const TreeNode> others, Buffer<SegmentPair>& pairs,
                  SearchCounts& counts) const {
    // Leaves of one curve seldom meet: most that come here run beside each other.
    SegmentBoxes boxes;
    BentSlab slab;
    bool has_boxes = false;
    if (self_) bent_slab(first_.leaf_points(leaf.index), slab);
    const auto begin = static_cast<std::uint32_t>(leaf.index * leaf_size);
    pairs.clear();
    for (const TreeNode& other : others) {
      const Point* const points = second_.leaf_points(other.index);
      std::uint32_t wanted = all_segments;
      if (self_) {
        wanted = other == leaf ? segments_meeting_earlier(points, first_.box(leaf)) : segments_meeting(slab, points);
      }
      if (wanted == 0) continue;
      if (!has_boxes) segment_boxes(first_.leaf_points(leaf.index), boxes);
      has_boxes = true;
      const std::size_t before = pairs.size();
      pairs.resize(before + leaf_size * leaf_size);
      const auto other_begin = static_cast<std::uint32_t>(other.index * leaf_size);
      std::size_t found =
          meeting_segments(boxes, begin, points, second_.box(other), other_begin, pairs.data() + before, wanted);
      if (self_) found = keep_upper(pairs.data() + before, found);
      pairs.resize(before + found);
    }
    drop_padding(pairs);
    counts.boxes_tested += others.size();
  }

  // Keeps those pairs of one curve that have first < second and can meet in more than a common end.
  [[nodiscard]] std::size_t keep_upper(SegmentPair* pairs, std::size_t count) const {
    const Point* const points = first_.curve().points.data();
    const std::size_t size = first_.curve().points.size();
    std::size_t kept = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const SegmentPair pair = pairs[k];
      if (pair.first >= pair.second) continue;
      const bool is_joint = pair.second == pair.first + 1 && pair.second + std::size_t{1} < size;
      if (!is_joint || !goes_on(points + pair.first)) pairs[kept++] = pair;
    }
    return kept;
  }
  // Whether the way through three points certainly turns by less than a right angle in the middle: then the two
  // segments have nothing but that in common.
  [[nodiscard]] static bool goes_on(const Point* points) {
    const double x0 = points[1].x - points[0].x, y0 = points[1].y - points[0].y;
    const double x1 = points[2].x - points[1].x, y1 = points[2].y - points[1].y;
    const double by_x = x0 * x1, by_y = y0 * y1;
    return by_x + by_y > 0x1p-50 * (std::fabs(by_x) + std::fabs(by_y)) + 0x1p-1000;
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
  bool stalls_;
  SelfTree tree_;
  const NodeStrips* strips1_ = nullptr;
  const NodeStrips* strips2_ = nullptr;
};

}  // namespace lober::detail
