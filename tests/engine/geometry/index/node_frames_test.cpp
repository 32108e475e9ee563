// Slanted rectangles never part what meets, and they part the two sides of a fold.
#include "engine/geometry/index/node_frames.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "kernels/cpu.hpp"
#include "tests/engine/geometry/index/scenes.hpp"
#include "tests/engine/geometry/index/search_testing.hpp"

namespace lober::test {
using namespace lober::detail;
namespace {

bool kept(const NodeFrames& first, TreeNode node, const NodeFrames& second, TreeNode other) {
  std::array<TreeNode, 1> list{other};
  return keep_near(first.of(node), second.pyramid(), list.data(), 1) == 1;
}

class Frames : public ::testing::TestWithParam<SceneKind> {};

TEST_P(Frames, KeepWhatMeets) {
  Random random(seed());
  for (const std::size_t size : {3U, 33U, 130U, 300U}) {
    if (size > GetParam().largest) break;
    const Scene made = GetParam().make(random, size);
    const CurveView one(made.first), two(made.second);
    const BoxTree first(one), second(two);
    const NodeFrames frames1(first), frames2(second);
    for (const SegmentPair& pair : pairs_with_common_point(one, two)) {
      for (std::uint32_t i = 0; i < first.levels(); ++i) {
        for (std::uint32_t j = 0; j < second.levels(); ++j) {
          const TreeNode node{i, static_cast<std::uint32_t>(pair.first / leaf_size) >> i};
          const TreeNode other{j, static_cast<std::uint32_t>(pair.second / leaf_size) >> j};
          ASSERT_TRUE(kept(frames1, node, frames2, other)) << pair.first << ' ' << i << ' ' << pair.second << ' ' << j;
          ASSERT_TRUE(kept(frames2, other, frames1, node));
        }
      }
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Scenes, Frames, ::testing::ValuesIn(scene_kinds()),
                         [](const auto& kind) { return std::string(kind.param.name); });

// Lines along a slanted direction, `apart` from each other, at any place: up to roundings of the coordinates.
TEST(NodeFrames, TellLinesApart) {
  for (const double far : {0.0, 1e6}) {
    for (const double apart : {1e-2, 1e-6, far == 0 ? 1e-12 : 1e-6}) {
      Curve lines[2];
      for (int which = 0; which < 2; ++which) {
        lines[which].closed = false;
        for (int k = 0; k <= 320; ++k) {
          const double t = k / 320.0;
          lines[which].points.push_back({far + 0.8 * t - 0.6 * apart * which, far + 0.6 * t + 0.8 * apart * which});
        }
      }
      const BoxTree first{CurveView(lines[0])}, second{CurveView(lines[1])};
      const NodeFrames frames1(first), frames2(second);
      ASSERT_TRUE(meet(first.box(), second.box()));
      EXPECT_FALSE(kept(frames1, first.root(), frames2, second.root())) << far << ' ' << apart;
    }
  }
}

TEST(NodeFrames, BothCopiesKeepTheSame) {
  if (!has_avx2()) GTEST_SKIP() << "no AVX2 on this machine";
  Random random(seed());
  const Scene made = scene_kinds()[0].make(random, 2000);
  const BoxTree tree{CurveView(made.first)};
  const NodeFrames frames(tree);
  std::vector<TreeNode> all;
  for (std::uint32_t level = 0; level < tree.levels(); ++level) {
    for (std::uint32_t k = 0; k < tree.nodes(level); ++k) all.push_back({level, k});
  }
  for (const TreeNode node : all) {
    std::vector<TreeNode> here = all, there = all;
    here.resize(keep_near(frames.of(node), frames.pyramid(), here.data(), here.size()));
    const InstructionSet before = instruction_set();
    limit_instruction_set(InstructionSet::baseline);
    there.resize(keep_near(frames.of(node), frames.pyramid(), there.data(), there.size()));
    limit_instruction_set(before);
    ASSERT_EQ(here, there);
  }
}

// Hairs side by side, enough of them for the search to use frames; one is bent into its neighbours.
TEST(FoldedCurve, IsSearchedCompletely) {
  constexpr int hairs = 256, along = 80;
  Curve curve;
  curve.closed = true;
  for (int k = 0; k < hairs; ++k) {
    for (const bool back : {false, true}) {
      for (int j = 0; j <= along; ++j) {
        const double t = (back ? along - j : j) / static_cast<double>(along), height = (2 * k + (back ? 1 : 0)) / 512.0;
        const double bent = k == 100 && !back ? 0.02 * std::sin(9 * t) : 0;
        curve.points.push_back({2 * t - height, t + 0.002 * t * t + height + bent});
      }
    }
  }
  curve.points.push_back({0, -1});
  curve.points.push_back({-3, 0});
  const IndexedCurve indexed(curve);
  Recorder by_tree(curve, curve), by_grid(curve, curve);
  const SearchCounts counts = find_self_pairs(indexed, by_tree);
  EXPECT_LT(counts.boxes_tested, 200 * curve.points.size() / leaf_size);
  (void)find_pairs(indexed, indexed, IndexKind::grid, by_grid);
  std::vector<SegmentPair> wanted;
  for (const SegmentPair& pair : by_grid.sorted()) {
    const auto size = static_cast<std::uint32_t>(curve.points.size());
    if (pair.second <= pair.first + 1 || (pair.first == 0 && pair.second + 1 == size)) continue;
    if (have_common_point(ends_of(curve, pair.first), ends_of(curve, pair.second))) wanted.push_back(pair);
  }
  EXPECT_GT(wanted.size(), 20U);
  const auto lost = missing(wanted, by_tree.sorted());
  EXPECT_TRUE(lost.empty()) << listed(lost);
}

}  // namespace
}  // namespace lober::test
