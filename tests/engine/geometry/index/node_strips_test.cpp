// Strips along parabolas never part what meets, and they part arcs side by side.
#include "engine/geometry/index/node_strips.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "kernels/cpu.hpp"
#include "tests/engine/geometry/index/scenes.hpp"
#include "tests/engine/geometry/index/search_testing.hpp"

namespace lober::test {
using namespace lober::detail;
namespace {

bool kept(const NodeStrips& first, TreeNode node, const NodeStrips& second, TreeNode other) {
  NodePair pair{node.index, other.index};
  return keep_near(first.strips(node.level), second.strips(other.level), &pair, 1) == 1;
}

class Strips : public ::testing::TestWithParam<SceneKind> {};

TEST_P(Strips, KeepWhatMeets) {
  Random random(seed());
  for (const std::size_t size : {3U, 33U, 130U, 300U, 700U}) {
    if (size > GetParam().largest) break;
    const Scene made = GetParam().make(random, size);
    const CurveView one(made.first), two(made.second);
    const BoxTree first(one), second(two);
    const NodeStrips strips1(first), strips2(second);
    for (const SegmentPair& pair : pairs_with_common_point(one, two)) {
      for (std::uint32_t i = 0; i < first.levels(); ++i) {
        for (std::uint32_t j = 0; j < second.levels(); ++j) {
          const TreeNode node{i, static_cast<std::uint32_t>(pair.first / leaf_size) >> i};
          const TreeNode other{j, static_cast<std::uint32_t>(pair.second / leaf_size) >> j};
          ASSERT_TRUE(kept(strips1, node, strips2, other)) << pair.first << ' ' << i << ' ' << pair.second << ' ' << j;
          ASSERT_TRUE(kept(strips2, other, strips1, node));
        }
      }
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Scenes, Strips, ::testing::ValuesIn(scene_kinds()),
                         [](const auto& kind) { return std::string(kind.param.name); });

// A point of an arc, of its chord or of a straight piece, which the strips of all nodes that hold it have to hold: a
// short needle through it meets them all, from whatever side.
TEST(NodeStrips, HoldEveryPointOfEverySegment) {
  Random random(seed());
  for (int k = 0; k < 200; ++k) {
    const double radius = random.log_uniform(0.1, 100), turn = random.log_uniform(0.01, 12);
    const double far = random.chance(0.3) ? 1e8 : 0, noise = random.chance(0.5) ? random.log_uniform(1e-9, 1) : 0;
    Curve arc{{}, false, ""}, needle{{}, false, ""};
    for (int j = 0; j < 200; ++j) {
      const double angle = turn * (j + 0.4 * random.unit()) / 200;
      arc.points.push_back({far + radius * std::cos(angle) + noise * random.unit(), radius * std::sin(angle)});
    }
    const std::size_t segment = static_cast<std::size_t>(random.integer(0, 198));
    const Point a = arc.points[segment], b = arc.points[segment + 1];
    const Point at{0.5 * a.x + 0.5 * b.x, 0.5 * a.y + 0.5 * b.y};
    const double angle = 6 * random.unit(), length = random.log_uniform(1e-6, 1);
    needle.points = {{at.x - length * std::cos(angle), at.y - length * std::sin(angle)},
                     {at.x + length * std::cos(angle), at.y + length * std::sin(angle)}};
    if (!have_common_point({a, b}, {needle.points[0], needle.points[1]})) continue;
    const BoxTree first{CurveView(arc)}, second{CurveView(needle)};
    const NodeStrips strips1(first), strips2(second);
    for (std::uint32_t level = 0; level < first.levels(); ++level) {
      const TreeNode node{level, static_cast<std::uint32_t>(segment / leaf_size) >> level};
      ASSERT_TRUE(kept(strips1, node, strips2, {0, 0})) << k << ' ' << level;
      ASSERT_TRUE(kept(strips2, {0, 0}, strips1, node)) << k << ' ' << level;
    }
  }
}

// Concentric arcs of half a radian, also where they begin and end elsewhere.
TEST(NodeStrips, TellArcsApart) {
  for (const double shift : {0.0, 0.1, -0.2}) {
    for (const double gap : {1e-2, shift == 0 ? 1e-3 : -1e-2}) {
      Curve arcs[2];
      for (int which = 0; which < 2; ++which) {
        arcs[which].closed = false;
        for (int k = 0; k <= 320; ++k) {
          const double angle = 0.3 + 0.5 * k / 320 + which * shift, radius = 1 + which * gap;
          arcs[which].points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
        }
      }
      const BoxTree first{CurveView(arcs[0])}, second{CurveView(arcs[1])};
      const NodeStrips strips1(first), strips2(second);
      ASSERT_TRUE(meet(first.box(), second.box()));
      EXPECT_FALSE(kept(strips1, first.root(), strips2, second.root())) << shift << ' ' << gap;
    }
  }
}

TEST(NodeStrips, OfWhatIsNotFinitePartNothing) {
  Curve curve = scene::circle(320, {0, 0}, 1);
  curve.points[70].x = std::numeric_limits<double>::quiet_NaN();
  curve.points[200].y = std::numeric_limits<double>::infinity();
  const BoxTree tree{CurveView(curve)};
  const NodeStrips strips(tree);
  for (const std::uint32_t leaf : {2U, 6U}) {
    for (std::uint32_t level = 0; level < tree.levels(); ++level) {
      EXPECT_TRUE(kept(strips, {level, leaf >> level}, strips, {0, 9}));
      EXPECT_TRUE(kept(strips, {0, 9}, strips, {level, leaf >> level}));
    }
  }
}

TEST(NodeStrips, BothCopiesDoTheSame) {
  if (!has_avx2()) GTEST_SKIP() << "no AVX2 on this machine";
  Random random(seed());
  for (const std::size_t kind : {0U, 2U, 6U}) {
    const Scene made = scene_kinds()[kind].make(random, 150);
    const BoxTree tree{CurveView(made.first)};
    const NodeStrips strips(tree);
    std::vector<TreeNode> all;
    for (std::uint32_t level = 0; level < tree.levels(); ++level) {
      for (std::uint32_t k = 0; k < tree.nodes(level); ++k) all.push_back({level, k});
    }
    const InstructionSet before = instruction_set();
    limit_instruction_set(InstructionSet::baseline);
    const NodeStrips baseline(tree);
    limit_instruction_set(before);
    for (const TreeNode node : all) {
      const Strip &here = strips.strips(node.level)[node.index], &there = baseline.strips(node.level)[node.index];
      ASSERT_EQ(std::memcmp(&here, &there, sizeof(Strip)), 0) << node.level << ' ' << node.index;
    }
    for (std::uint32_t first = 0; first < tree.levels(); ++first) {
      for (std::uint32_t second = 0; second < tree.levels(); ++second) {
        std::vector<NodePair> here;
        for (std::uint32_t i = 0; i < tree.nodes(first); ++i) {
          for (std::uint32_t j = 0; j < tree.nodes(second); ++j) here.push_back({i, j});
        }
        std::vector<NodePair> there = here;
        here.resize(keep_near(strips.strips(first), strips.strips(second), here.data(), here.size()));
        limit_instruction_set(InstructionSet::baseline);
        there.resize(keep_near(strips.strips(first), strips.strips(second), there.data(), there.size()));
        limit_instruction_set(before);
        ASSERT_EQ(here, there);
      }
    }
  }
}

}  // namespace
}  // namespace lober::test
