// Slanted rectangles never part what meets, and they part the two sides of a fold.
#include "engine/geometry/index/node_frames.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "engine/geometry/index/pair_walk.hpp"
#include "kernels/cpu.hpp"
#include "tests/engine/geometry/index/scenes.hpp"
#include "tests/engine/geometry/index/search_testing.hpp"

namespace lober::test {
using namespace lober::detail;
namespace {

struct Framed {
  explicit Framed(const CurveView& curve) : tree(curve), frames(tree) {}
  BoxTree tree;
  NodeFrames frames;
};

using Lists = std::vector<std::vector<TreeNode>>;

// The nodes found for the nodes of `level` below `top`, of `list` and what lies below it. A curve with itself, if both
// are the same.
Lists descended(const Framed& first, TreeNode top, std::uint32_t level, const Framed& second,
                const std::vector<TreeNode>& list) {
  MeetingLists met;
  SearchCounts counts;
  const auto walk = &first == &second ? PairWalk(first.frames) : PairWalk(first.frames, second.frames);
  walk.go_down(top, level, list, std::size_t{1} << 32, met, counts);
  Lists lists;
  for (std::uint32_t k = 0; k < met.size(); ++k) lists.emplace_back(met[k].begin(), met[k].end());
  return lists;
}
// Those found for `node` and those beside it.
Lists descended(const Framed& first, TreeNode node, const Framed& second, const std::vector<TreeNode>& list) {
  return descended(first, {node.level + levels_at_once, node.index / 4}, node.level, second, list);
}

// Whether something of `other` is found for `node`; if a leaf is given, that leaf or what it lies in.
bool kept(const Framed& first, TreeNode node, const Framed& second, TreeNode other,
          std::optional<std::uint32_t> leaf = std::nullopt) {
  const Lists met = descended(first, node, second, {other});
  const std::vector<TreeNode>& found = met[node.index % nodes_at_once];
  return std::any_of(found.begin(), found.end(),
                     [&](TreeNode below) { return !leaf || *leaf >> below.level == below.index; });
}

class Frames : public ::testing::TestWithParam<SceneKind> {};

TEST_P(Frames, KeepWhatMeets) {
  Random random(seed());
  for (const std::size_t size : {3U, 33U, 130U, 300U}) {
    if (size > GetParam().largest) break;
    const Scene made = GetParam().make(random, size);
    const CurveView one(made.first), two(made.second);
    const Framed first(one), second(two);
    for (const SegmentPair& pair : pairs_with_common_point(one, two)) {
      for (std::uint32_t i = 0; i < first.tree.levels(); i += levels_at_once) {
        for (std::uint32_t j = 0; j < second.tree.levels(); j += levels_at_once) {
          const auto leaf = static_cast<std::uint32_t>(pair.first / leaf_size);
          const auto other_leaf = static_cast<std::uint32_t>(pair.second / leaf_size);
          const TreeNode node{i, leaf >> i}, other{j, other_leaf >> j};
          ASSERT_TRUE(kept(first, node, second, other, other_leaf))
              << pair.first << ' ' << i << ' ' << pair.second << ' ' << j;
          ASSERT_TRUE(kept(second, other, first, node, leaf));
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
      const Framed first{CurveView(lines[0])}, second{CurveView(lines[1])};
      ASSERT_TRUE(meet(first.tree.box(), second.tree.box()));
      EXPECT_FALSE(kept(first, first.tree.root(), second, second.tree.root())) << far << ' ' << apart;
    }
  }
}

// Pieces of one slanted line, one behind the other: their boxes are apart too, and frames have to know it.
TEST(NodeFrames, TellPiecesOfALineApart) {
  Curve line;
  line.closed = false;
  for (int k = 0; k <= 1280; ++k) line.points.push_back({0.8 * k, 0.6 * k});
  const Framed framed{CurveView(line)}, twin{CurveView(line)};  // of one curve all pieces are one monotone run
  for (const std::uint32_t level : {0U, 2U}) {
    for (std::uint32_t k = 0; k < framed.tree.nodes(level); ++k) {
      EXPECT_TRUE(kept(framed, {level, 0}, twin, {level, k}) == (k <= 1)) << level << ' ' << k;
    }
  }
}

TEST(NodeFrames, AllCopiesMakeTheSame) {
  if (!has_avx2()) GTEST_SKIP() << "no AVX2 on this machine";
  Random random(seed());
  const InstructionSet before = instruction_set();
  for (const SceneKind& kind : scene_kinds()) {
    const Scene made = kind.make(random, std::min<std::size_t>(kind.largest, 2000));
    const Framed framed{CurveView(made.first)};
    limit_instruction_set(InstructionSet::baseline);
    const Framed other{CurveView(made.first)};
    limit_instruction_set(before);
    for (std::uint32_t level = 0; level < framed.tree.levels(); level += levels_at_once) {
      for (std::uint32_t k = 0; k < framed.tree.nodes(level); ++k) {
        const FourFrames &here = framed.frames.level(level).frames[k / 4],
                         &there = other.frames.level(level).frames[k / 4];
        ASSERT_EQ(std::memcmp(&here, &there, sizeof here), 0) << kind.name << ' ' << level << ' ' << k;
      }
    }
  }
}

TEST(NodeFrames, BothCopiesKeepTheSame) {
  if (!has_avx2()) GTEST_SKIP() << "no AVX2 on this machine";
  Random random(seed());
  const Scene made = scene_kinds()[0].make(random, 2000);
  const Framed framed{CurveView(made.first)};
  std::vector<TreeNode> all;
  for (std::uint32_t level = 0; level < framed.tree.levels(); level += levels_at_once) {
    for (std::uint32_t k = 0; k < framed.tree.nodes(level); ++k) all.push_back({level, k});
  }
  const Framed twin{CurveView(made.first)};  // for the tree it is another curve
  for (const TreeNode node : all) {
    for (const Framed* second : {&framed, &twin}) {
      const Lists here = descended(framed, node, *second, all);
      const InstructionSet before = instruction_set();
      limit_instruction_set(InstructionSet::baseline);
      const Lists there = descended(framed, node, *second, all);
      limit_instruction_set(before);
      ASSERT_EQ(here, there);
    }
  }
}

// For a curve with itself: nothing before a node, and nothing that goes on as one run with it.
TEST(NodeFrames, FindEachPairOfNodesOnce) {
  Curve curve;
  curve.closed = false;
  for (int k = 0; k <= 64 * 32; ++k) {
    const double t = k / 512.0, back = std::fabs(t - 2);  // out and back again
    curve.points.push_back({back, 1e-3 * t});
  }
  curve.points.push_back({-1, 0});
  const Framed framed{CurveView(curve)};
  for (std::uint32_t leaf = 0; leaf < framed.tree.leaves(); ++leaf) {
    const auto met = descended(
        framed, {0, leaf}, framed,
        {framed.tree.root().level % 2 == 0 ? framed.tree.root()
                                           : TreeNode{framed.tree.root().level - 1, 0}})[leaf % nodes_at_once];
    for (const TreeNode other : met) {
      EXPECT_FALSE(nothing_between({framed.tree.pyramid(), framed.tree.as_self().flags, false}, {0, leaf}, other));
      EXPECT_GE(other.index, leaf);
    }
  }
}

// Hairs side by side, enough of them for the search to use frames; one is bent into its neighbours.
Curve hairs() {
  constexpr int count = 256, along = 80;
  Curve curve;
  curve.closed = true;
  for (int k = 0; k < count; ++k) {
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
  return curve;
}

TEST(FoldedCurve, IsSearchedCompletely) {
  const Curve curve = hairs();
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

TEST(FoldedCurve, IsSearchedCompletelyForAnotherOne) {
  const Curve curve = hairs();
  Curve across = curve;  // bundles across bundles
  for (Point& p : across.points) p = {0.3 + 0.9 * p.y - 0.2 * p.x, 0.4 + 0.8 * p.x};
  const IndexedCurve first(curve), second(across);
  expect_complete_search(first, second, 10'000);
  EXPECT_TRUE(first.tree().frames() != nullptr && second.tree().frames() != nullptr) << "frames should have served";
}

// A curve may come twice, as two.
TEST(FoldedCurve, IsSearchedCompletelyForItselfAsAnotherOne) {
  const Curve curve = hairs();
  const IndexedCurve indexed(curve);
  indexed.tree().make_frames();
  expect_complete_search(indexed, indexed, 3 * curve.points.size() - 10);  // itself and its neighbours
}

// Where both stay in one point, each leaf there would meet each.
TEST(FoldedCurve, MayStallWithAnotherOne) {
  Curve one = hairs(), other = one;
  for (Point& p : other.points) p = {p.y, p.x};
  const auto search = [&] {
    const IndexedCurve first(one), second(other);
    first.tree().make_frames();
    second.tree().make_frames();
    Recorder recorder(one, other);
    return find_pairs(first, second, IndexKind::tree, recorder).boxes_tested;
  };
  const std::uint64_t moving = search();
  const std::size_t in_common = 5000;
  other.points[in_common] = one.points[in_common];
  for (Curve* curve : {&one, &other}) {
    const Point stay = curve->points[in_common];
    curve->points.insert(curve->points.begin() + in_common, 100'000, stay);
  }
  EXPECT_LT(search(), 2 * moving);
}

}  // namespace
}  // namespace lober::test
