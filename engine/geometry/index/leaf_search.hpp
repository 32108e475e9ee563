// The pairs of segments of leaves that were found to be near each other (private to index/).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/geometry/index/box_tree.hpp"
#include "engine/geometry/index/index.hpp"
#include "engine/geometry/index/leaf_turns.hpp"
#include "kernels/bent_slab.hpp"
#include "kernels/box_pyramid.hpp"
#include "lober/base/buffer.hpp"

namespace lober::detail {

class LeafSearch {
 public:
  /// With `self` the two trees are one.
  LeafSearch(const BoxTree& first, const BoxTree& second, bool self) : first_(first), second_(second), self_(self) {}

  /// Memory of a search, what it counts, and the segment of the first curve before which nothing is wanted any more.
  struct Scratch {
    Buffer<SegmentPair> pairs;
    std::uint32_t skip_before = 0;
    SearchCounts counts;
  };

  /// Hands the pairs of a leaf of the first tree with those of `list` to the consumer.
  void search(std::uint32_t leaf, std::span<const TreeNode> list, std::uint32_t block, PairConsumer& consumer,
              Scratch& scratch) const {
    if (list.empty() || (std::size_t{leaf} + 1) * leaf_size <= scratch.skip_before) return;
    leaf_pairs(leaf, list, scratch.pairs, scratch.counts);
    if (scratch.pairs.empty()) return;
    scratch.counts.pairs_proposed += scratch.pairs.size();
    scratch.skip_before = consumer.consume(block, scratch.pairs);
  }

  /// Whether the trees have so few leaves that levels above them save nothing.
  [[nodiscard]] bool has_few_leaves() const {
    const bool stalls = first_.stalls() || second_.stalls();
    return !self_ && !stalls && std::max(first_.leaves(), second_.leaves()) <= few_leaves;
  }
  /// Hands the pairs of all leaves of two such trees to the consumer, as one block: those of the first tree, four at a
  /// time, are held against all of the second that meet its box.
  void search_few(PairConsumer& consumer, Scratch& scratch) const {
    std::array<NodePair, few_leaves> pairs;  // four leaves with one
    std::array<NodePair, nodes_at_once * few_leaves + nodes_at_once> met, unused;
    std::array<std::array<TreeNode, few_leaves>, nodes_at_once> near;
    const BoxQuery query(first_.box());
    std::size_t size = 0;
    for (std::uint32_t leaf = 0; leaf < second_.leaves(); ++leaf) {
      pairs[size] = {0, leaf};
      size += static_cast<std::size_t>(meet(query, second_.leaf_boxes()[leaf]));
    }
    scratch.counts.boxes_tested += second_.leaves();
    for (std::uint32_t begin = 0; begin < first_.leaves(); begin += nodes_at_once) {
      for (std::size_t k = 0; k < size; ++k) pairs[k].first = begin / nodes_at_once;
      const std::size_t found =
          pairs_below_first(first_.level(0), second_.level(0), pairs.data(), size, Keep::all, met.data(), unused.data())
              .kept;
      scratch.counts.boxes_tested += nodes_at_once * size;
      std::array<std::size_t, nodes_at_once> count{};
      for (std::size_t k = 0; k < found; ++k) {
        const std::size_t i = met[k].first - begin;
        near[i][count[i]++] = {0, met[k].second};
      }
      for (std::uint32_t i = 0; i < nodes_at_once; ++i) {
        search(begin + i, {near[i].data(), count[i]}, 0, consumer, scratch);
      }
    }
  }

 private:
  static constexpr std::size_t few_leaves = 32;

  void leaf_pairs(std::uint32_t leaf, std::span<const TreeNode> others, Buffer<SegmentPair>& pairs,
                  SearchCounts& counts) const {
    // Leaves of one curve seldom meet: most that come here run beside each other.
    SegmentBoxes boxes;
    BentSlab slab;
    bool has_boxes = false;
    if (self_) bent_slab(first_.leaf_points(leaf), slab);
    const auto begin = static_cast<std::uint32_t>(leaf * leaf_size);
    pairs.clear();
    for (const TreeNode& other : others) {
      const Point* const points = second_.leaf_points(other.index);
      std::uint32_t wanted = all_segments;
      if (self_) {
        wanted = other.index == leaf ? segments_meeting_earlier(points, first_.leaf_boxes()[leaf])
                                     : segments_meeting(slab, points);
      }
      if (wanted == 0) continue;
      if (!has_boxes) segment_boxes(first_.leaf_points(leaf), boxes);
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
};

}  // namespace lober::detail
