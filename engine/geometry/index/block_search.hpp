// Common parts of the searches that look up one segment of the first curve after the other (private to this folder).
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/index/index.hpp"
#include "lober/base/buffer.hpp"

namespace lober::detail {

/// The common part of two boxes, which must meet. All common points of two curves lie in that of their boxes.
inline Box intersection(const Box& a, const Box& b) {
  return {{std::max(a.lane[0], b.lane[0]), std::max(a.lane[1], b.lane[1]), std::max(a.lane[2], b.lane[2]),
           std::max(a.lane[3], b.lane[3])}};
}

/// Calls visit(segment, ends) for each segment of leaf `leaf` that has a length and whose box meets the
/// window.
template <typename Visit>
void for_each_segment_of_leaf(const BoxTree& tree, std::size_t leaf, const Box& window, const Visit& visit) {
  if (!meet(tree.leaf_boxes()[leaf], window)) return;
  const Point* points = tree.leaf_points(leaf);
  const auto begin = static_cast<std::uint32_t>(leaf * leaf_size);
  for (std::uint32_t k = 0; k < leaf_size; ++k) {  // the padding of the last leaf has no length
    const Segment ends{points[k], points[k + 1]};
    if (!(ends.a == ends.b) && meet(Box::of(ends.a, ends.b), window)) visit(begin + k, ends);
  }
}

/// The level of the nodes of a tree that are its blocks.
inline std::uint32_t block_level(const BoxTree& tree) {
  return std::min(static_cast<std::uint32_t>(std::countr_zero(block_segments / leaf_size)), tree.levels() - 1);
}

/// The result of a search of curves whose boxes do not meet.
inline SearchCounts search_nothing(const BoxTree& first) {
  SearchCounts counts;
  counts.boxes_tested = 1;
  counts.blocks_skipped = first.nodes(block_level(first));
  return counts;
}

/// Looks up the segments of `first` that meet the window, in parallel by blocks; each block has its own
/// find = make_finder(). find(ends, box, candidates) appends the segments of the second curve whose boxes
/// meet `box`, each once, always in the same order, and returns how many comparisons that took.
template <typename MakeFinder>
SearchCounts search_blocks(const BoxTree& first, const Box& window, PairConsumer& consumer,
                           const MakeFinder& make_finder) {
  constexpr std::uint32_t leaves_per_block = block_segments / leaf_size;
  const std::uint32_t level = block_level(first);
  const std::uint32_t blocks = first.nodes(level);
  std::vector<SearchCounts> block_counts(blocks);
  const auto search_block = [&](std::uint32_t block, SearchCounts& counts) {
    auto find = make_finder();
    Buffer<SegmentPair> pairs;
    Buffer<std::uint32_t> candidates;
    std::uint32_t skip_before = 0;
    const std::size_t end = std::min<std::size_t>((block + std::size_t{1}) * leaves_per_block, first.leaves());
    for (std::size_t leaf = block * std::size_t{leaves_per_block}; leaf < end; ++leaf) {
      if ((leaf + 1) * leaf_size <= skip_before) continue;
      pairs.clear();
      for_each_segment_of_leaf(first, leaf, window, [&](std::uint32_t segment, const Segment& ends) {
        if (segment < skip_before) return;
        candidates.clear();
        counts.boxes_tested += find(ends, Box::of(ends.a, ends.b), candidates);
        for (const std::uint32_t other : candidates) pairs.push_back({segment, other});
      });
      if (pairs.empty()) continue;
      counts.pairs_proposed += pairs.size();
      skip_before = consumer.consume(block, pairs);
    }
    consumer.finish(block);
  };
  for_each_block(blocks, 1, [&](std::size_t block, std::size_t) {
    SearchCounts& counts = block_counts[block];
    const auto number = static_cast<std::uint32_t>(block);
    const bool near = meet(first.box({level, number}), window);
    counts.blocks_searched = near ? 1 : 0;
    counts.blocks_skipped = near ? 0 : 1;
    if (near) search_block(number, counts);
  });
  SearchCounts total;
  for (const SearchCounts& counts : block_counts) total += counts;
  return total;
}

}  // namespace lober::detail
