// The pairs that a search hands over, recorded and checked, and the brute-force twin of all searches.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/geometry/index/index.hpp"
#include "kernels/box.hpp"
#include "tests/kernels/random_doubles.hpp"

namespace lober::test {
using namespace lober::detail;

struct Ends {
  Point a, b;
};
inline Ends ends_of(const CurveView& curve, std::size_t segment) {
  return {curve.points[segment], curve.points[segment + 1 == curve.points.size() ? 0 : segment + 1]};
}

/// Whether two closed segments, neither of length zero, have a point in common. Exact.
inline bool have_common_point(const Ends& s, const Ends& t) {
  if (!meet(Box::of(s.a, s.b), Box::of(t.a, t.b))) return false;
  return exact_orientation(s.a, s.b, t.a) * exact_orientation(s.a, s.b, t.b) <= 0 &&
         exact_orientation(t.a, t.b, s.a) * exact_orientation(t.a, t.b, s.b) <= 0;
}

inline std::vector<SegmentPair> pairs_with_common_point(const CurveView& first, const CurveView& second) {
  std::vector<SegmentPair> pairs;
  for (std::uint32_t i = 0; i < first.segments(); ++i) {
    const Ends s = ends_of(first, i);
    if (s.a == s.b) continue;
    for (std::uint32_t j = 0; j < second.segments(); ++j) {
      const Ends t = ends_of(second, j);
      if (!(t.a == t.b) && have_common_point(s, t)) pairs.push_back({i, j});
    }
  }
  return pairs;
}

/// Whether segments i < j have more in common than the end that joins them.
inline bool meet_beyond_a_joint(const CurveView& curve, std::uint32_t i, std::uint32_t j) {
  const Ends s = ends_of(curve, i), t = ends_of(curve, j);
  if (s.a == s.b || t.a == t.b || !have_common_point(s, t)) return false;
  const bool follows = j == i + 1, wraps = curve.closed && i == 0 && j + 1 == curve.segments();
  if (!follows && !wraps) return true;
  // Neighbours, of which the joint is known, meet elsewhere only when they fold back onto each other.
  const Ends& before = follows ? s : t;
  const Ends& after = follows ? t : s;
  if (exact_orientation(before.a, before.b, after.b) != 0) return false;
  const auto turns_back = [](double from, double joint, double to) {
    return (from < joint && to < joint) || (from > joint && to > joint);
  };
  return turns_back(before.a.x, before.b.x, after.b.x) || turns_back(before.a.y, before.b.y, after.b.y);
}

/// All pairs i < j of segments of a curve that do.
inline std::vector<SegmentPair> pairs_beyond_joints(const CurveView& curve) {
  std::vector<SegmentPair> pairs;
  const auto segments = static_cast<std::uint32_t>(curve.segments());
  for (std::uint32_t i = 0; i < segments; ++i) {
    for (std::uint32_t j = i + 1; j < segments; ++j) {
      if (meet_beyond_a_joint(curve, i, j)) pairs.push_back({i, j});
    }
  }
  return pairs;
}

/// Keeps everything, block by block, and complains about whatever a search must not do.
class Recorder : public PairConsumer {
 public:
  Recorder(const CurveView& first, const CurveView& second)
      : first_(first), second_(second), blocks_((first.segments() + block_segments - 1) / block_segments) {}

  std::uint32_t consume(std::uint32_t number, std::span<const SegmentPair> pairs) override {
    Block& block = blocks_.at(number);
    EXPECT_FALSE(block.finished) << "pairs after the end of block " << number;
    EXPECT_FALSE(pairs.empty());
    const std::size_t leaf = pairs.front().first / leaf_size;
    EXPECT_GE(leaf, block.next_leaf) << "runs of the first curve must ascend";
    block.next_leaf = leaf + 1;
    for (const SegmentPair& pair : pairs) {
      EXPECT_EQ(pair.first / leaf_size, leaf);
      EXPECT_EQ(pair.first / block_segments, number);
      EXPECT_LT(pair.first, first_.segments());
      EXPECT_LT(pair.second, second_.segments());
    }
    block.pairs.insert(block.pairs.end(), pairs.begin(), pairs.end());
    return skip_before(static_cast<std::uint32_t>(leaf));
  }
  void finish(std::uint32_t number) override {
    EXPECT_FALSE(blocks_.at(number).finished) << "block " << number << " finished twice";
    blocks_.at(number).finished = true;
  }

  /// All pairs of a block in the order in which they came.
  [[nodiscard]] std::vector<std::vector<SegmentPair>> by_block() const {
    std::vector<std::vector<SegmentPair>> result;
    for (const Block& block : blocks_) {
      EXPECT_TRUE(block.finished || block.pairs.empty()) << "a block without end";
      result.push_back(block.pairs);
    }
    return result;
  }
  /// All pairs, sorted; complains when one came twice.
  [[nodiscard]] std::vector<SegmentPair> sorted() const {
    std::vector<SegmentPair> all;
    for (const auto& block : by_block()) all.insert(all.end(), block.begin(), block.end());
    std::sort(all.begin(), all.end());
    EXPECT_TRUE(std::adjacent_find(all.begin(), all.end()) == all.end()) << "a pair came twice";
    return all;
  }

 protected:
  /// The answer after the pairs of a leaf.
  virtual std::uint32_t skip_before(std::uint32_t) { return 0; }

 private:
  struct Block {
    std::vector<SegmentPair> pairs;
    std::size_t next_leaf = 0;
    bool finished = false;
  };
  CurveView first_, second_;
  std::vector<Block> blocks_;
};

/// The first few, for messages.
inline std::string listed(const std::vector<SegmentPair>& pairs) {
  std::string text;
  for (std::size_t k = 0; k < std::min<std::size_t>(pairs.size(), 8); ++k) {
    text += "(" + std::to_string(pairs[k].first) + " " + std::to_string(pairs[k].second) + ") ";
  }
  return text + "out of " + std::to_string(pairs.size());
}

/// Elements of `wanted` that are not in `found`; both sorted.
inline std::vector<SegmentPair> missing(const std::vector<SegmentPair>& wanted, const std::vector<SegmentPair>& found) {
  std::vector<SegmentPair> result;
  std::set_difference(wanted.begin(), wanted.end(), found.begin(), found.end(), std::back_inserter(result));
  return result;
}

inline bool same(const SearchCounts& a, const SearchCounts& b) {
  return a.boxes_tested == b.boxes_tested && a.pairs_proposed == b.pairs_proposed &&
         a.blocks_searched == b.blocks_searched && a.blocks_skipped == b.blocks_skipped;
}

/// Expects of the search by trees all pairs of segments with a common point that the one by a grid finds, which are to
/// be more than that many.
inline void expect_complete_search(const IndexedCurve& first, const IndexedCurve& second, std::size_t more_than) {
  Recorder by_tree(first.view(), second.view()), by_grid(first.view(), second.view());
  (void)find_pairs(first, second, IndexKind::tree, by_tree);
  (void)find_pairs(first, second, IndexKind::grid, by_grid);
  std::vector<SegmentPair> wanted;
  for (const SegmentPair& pair : by_grid.sorted()) {
    if (have_common_point(ends_of(first.view(), pair.first), ends_of(second.view(), pair.second))) {
      wanted.push_back(pair);
    }
  }
  EXPECT_GT(wanted.size(), more_than);
  const auto lost = missing(wanted, by_tree.sorted());
  EXPECT_TRUE(lost.empty()) << listed(lost);
}

}  // namespace lober::test
