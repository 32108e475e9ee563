// Which leaves of one curve may meet: all that do are listed, for folds of every kind, and few others.
#include "engine/geometry/index/window_search.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "engine/base/parallel/parallel.hpp"
#include "tests/engine/geometry/index/scenes.hpp"
#include "tests/engine/geometry/index/search_testing.hpp"

namespace lober::test {
using namespace lober::detail;
namespace {

bool lists(const NearLeaves& near, std::uint32_t leaf, std::uint32_t other) {
  const auto others = near.of(leaf);
  return std::any_of(others.begin(), others.end(),
                     [&](TreeNode node) { return node.level == 0 && node.index == other; });
}

void expect_complete_lists(const Curve& curve) {
  SearchCounts counts;
  const BoxTree tree{CurveView(curve)};
  const NearLeaves near(tree, counts);
  if (!near.is_complete()) return;
  for (const SegmentPair& pair : pairs_beyond_joints(curve)) {
    ASSERT_TRUE(lists(near, pair.first / leaf_size, pair.second / leaf_size)) << pair.first << ' ' << pair.second;
  }
  for (std::uint32_t leaf = 0; leaf < tree.leaves(); ++leaf) {
    const auto others = near.of(leaf);
    EXPECT_TRUE(std::is_sorted(others.begin(), others.end(), [](TreeNode a, TreeNode b) { return a.index < b.index; }));
    EXPECT_TRUE(others.empty() || others.front().index >= leaf);
  }
}

class Windows : public ::testing::TestWithParam<SceneKind> {};

TEST_P(Windows, ListAllThatMeets) {
  Random random(seed());
  for (const std::size_t size : {3U, 33U, 130U, 2049U, 5000U}) {
    if (size > GetParam().largest) break;
    SCOPED_TRACE(size);
    const Scene made = GetParam().make(random, size);
    expect_complete_lists(made.first);
    expect_complete_lists(made.second);
  }
}
INSTANTIATE_TEST_SUITE_P(Scenes, Windows, ::testing::ValuesIn(scene_kinds()),
                         [](const auto& kind) { return std::string(kind.param.name); });

TEST(WindowsOfStalls, ACurveOfOnePointHasNone) {
  for (const std::size_t size : {3U, 33U, 5000U}) {
    SearchCounts counts;
    const Curve curve{std::vector<Point>(size, Point{1, 2}), true, ""};
    const NearLeaves near(BoxTree{CurveView(curve)}, counts);
    ASSERT_TRUE(near.is_complete());
    for (std::uint32_t leaf = 0; leaf < size / leaf_size; ++leaf) EXPECT_TRUE(near.of(leaf).empty());
  }
}

// Hairs bent round half a turn, side by side; `bent` of them into their neighbours.
Curve long_hairs(std::size_t hairs, std::size_t along, std::size_t bent) {
  Curve curve{{}, true, ""};
  for (std::size_t k = 0; k < 2 * hairs; ++k) {
    const double radius = 2 - static_cast<double>(k) / static_cast<double>(2 * hairs);
    for (std::size_t j = 0; j <= along; ++j) {
      const double turn = static_cast<double>(k % 2 == 0 ? j : along - j) / static_cast<double>(along);
      const double off = k % 7 == 3 && k < 7 * bent ? 0.01 * std::sin(9 * turn) : 0;
      curve.points.push_back({(radius + off) * std::cos(3.1 * turn), (radius + off) * std::sin(3.1 * turn)});
    }
  }
  curve.points.push_back({0.9, -0.1});
  curve.points.push_back({2.1, -0.1});
  return curve;
}

TEST(Windows, ListAllThatMeetsAmongLongHairs) {
  expect_complete_lists(long_hairs(40, 100, 3));
}

TEST(Windows, TakeFewTestsForLongHairs) {
  const Curve curve = long_hairs(300, 300, 0);
  const BoxTree tree{CurveView(curve)};
  SearchCounts counts;
  const NearLeaves near(tree, counts);
  ASSERT_TRUE(near.is_complete());
  EXPECT_LT(counts.boxes_tested, 250 * tree.leaves());
  std::size_t listed = 0;
  for (std::uint32_t leaf = 0; leaf < tree.leaves(); ++leaf) listed += near.of(leaf).size();
  EXPECT_LT(listed, 6 * tree.leaves());
  // Boxes alone: each leaf meets a good part of all.
  std::size_t meetings = 0;
  for (std::size_t k = 0; k < tree.leaves(); k += 97) {
    for (std::size_t j = 0; j < tree.leaves(); ++j)
      meetings += meet(tree.leaf_boxes()[k], tree.leaf_boxes()[j]) ? 97 : 0;
  }
  EXPECT_GT(meetings, 40 * tree.leaves());
}

// The search that users run takes windows here, and finds what the grid finds.
TEST(Windows, AreUsedBySearches) {
  const Curve curve = long_hairs(512, 250, 60);
  const IndexedCurve indexed(curve);
  Recorder by_windows(curve, curve), by_grid(curve, curve);
  const SearchCounts counts = find_self_pairs(indexed, by_windows);
  EXPECT_LT(counts.boxes_tested, 500 * indexed.tree().leaves());
  (void)find_pairs(indexed, indexed, IndexKind::grid, by_grid);
  std::vector<SegmentPair> wanted;
  for (const SegmentPair& pair : by_grid.sorted()) {
    if (pair.first < pair.second && meet_beyond_a_joint(curve, pair.first, pair.second)) wanted.push_back(pair);
  }
  EXPECT_GT(wanted.size(), 100U);
  const auto lost = missing(wanted, by_windows.sorted());
  EXPECT_TRUE(lost.empty()) << listed(lost);
}

TEST(Windows, AreTheSameForAnyNumberOfThreads) {
  const tbb::global_control at_most(tbb::global_control::max_allowed_parallelism, 7);
  const Curve curve = long_hairs(100, 200, 5);
  const BoxTree tree{CurveView(curve)};
  SearchCounts expected_counts;
  const NearLeaves expected = with_threads(1, [&] { return NearLeaves(tree, expected_counts); });
  for (const int threads : {2, 7}) {
    SearchCounts counts;
    const NearLeaves near = with_threads(threads, [&] { return NearLeaves(tree, counts); });
    EXPECT_EQ(counts.boxes_tested, expected_counts.boxes_tested);
    for (std::uint32_t leaf = 0; leaf < tree.leaves(); ++leaf) {
      const auto one = near.of(leaf), other = expected.of(leaf);
      ASSERT_TRUE(std::equal(one.begin(), one.end(), other.begin(), other.end())) << leaf;
    }
  }
}

// Long segments across each other at random: windows give up, with little memory.
TEST(Windows, GiveUpWhereEverythingLiesAcross) {
  Random random(seed());
  Curve curve{{}, true, ""};
  for (int k = 0; k < 40000; ++k) curve.points.push_back({random.unit(), random.unit()});
  SearchCounts counts;
  EXPECT_FALSE(NearLeaves(BoxTree{CurveView(curve)}, counts).is_complete());
}

}  // namespace
}  // namespace lober::test
