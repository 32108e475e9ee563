// Walks of two trees by pairs of nodes: nothing is lost on the way down, and nothing else comes out.
#include "engine/geometry/index/pair_walk.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "kernels/cpu.hpp"
#include "lober/overlay/crossings.hpp"
#include "tests/engine/geometry/index/scenes.hpp"
#include "tests/engine/geometry/index/search_testing.hpp"

namespace lober::test {
using namespace lober::detail;
namespace {

constexpr std::size_t all_pairs = std::size_t{1} << 32;

using NodeLists = std::vector<std::vector<TreeNode>>;

template <typename Nodes>
NodeLists below(const PairWalk<Nodes>& walk, TreeNode top, std::uint32_t level, const std::vector<TreeNode>& list) {
  MeetingLists met;
  SearchCounts counts;
  EXPECT_EQ(walk.go_down(top, level, list, all_pairs, met, counts), level);
  NodeLists lists;
  for (std::uint32_t k = 0; k < met.size(); ++k) {
    lists.emplace_back(met[k].begin(), met[k].end());
    std::sort(lists.back().begin(), lists.back().end(),
              [](TreeNode a, TreeNode b) { return std::pair(a.level, a.index) < std::pair(b.level, b.index); });
  }
  return lists;
}
template <typename Nodes>
NodeLists leaves_of(const PairWalk<Nodes>& walk, const BoxTree& first, const BoxTree& second) {
  return below(walk, top_of(first.levels()), 0, roots_of(second.levels()));
}

// Two levels at a time.
template <typename Nodes>
NodeLists leaves_step_by_step(const PairWalk<Nodes>& walk, const BoxTree& first, const BoxTree& second) {
  NodeLists lists{roots_of(second.levels())};
  for (std::uint32_t level = top_of(first.levels()).level; level > 0; level -= levels_at_once) {
    NodeLists next;
    for (std::uint32_t k = 0; k < lists.size(); ++k) {
      for (auto& list : below(walk, {level, k}, level - levels_at_once, lists[k])) next.push_back(std::move(list));
    }
    lists = std::move(next);
  }
  return lists;
}

// Segments at random over all of the plane: each leaf meets each, and all pairs of them are too many to be held. The
// first one tells that the curve crosses itself.
TEST(PairWalk, EndsWherePairsAreTooMany) {
  Random random(seed());
  Curve scribble;
  scribble.closed = false;
  for (int k = 0; k < 200'000; ++k) scribble.points.push_back({random.uniform(0, 1), random.uniform(0, 1)});
  const BoxTree tree{CurveView(scribble)};
  const NodeBoxes boxes(tree);
  MeetingLists lists;
  SearchCounts counts;
  const TreeNode top = top_of(tree.levels());
  const std::uint32_t level = PairWalk(boxes).go_down(top, 0, roots_of(tree.levels()), 1000, lists, counts);
  EXPECT_GT(level, 0U);
  EXPECT_EQ(lists.size(), 1U << (top.level - level));
  EXPECT_LT(counts.boxes_tested, 100'000U);
  EXPECT_THROW(require_simple(IndexedCurve(scribble), 1), NotSimpleError);
}

// A tree of one leaf against larger ones.
TEST(PairWalk, SplitsWhatOneLeafMeets) {
  Curve triangle;
  triangle.closed = true;
  triangle.points = {{-2, -0.1}, {2, 0}, {-2, 0.1}};
  for (const int size : {100, 1000, 1100, 3000, 20000}) {
    Curve wave;
    wave.closed = false;
    for (int k = 0; k <= size; ++k) wave.points.push_back({std::cos(k * 0.7), std::sin(k * 0.7)});
    for (const auto& [first, second] : {std::pair(triangle, wave), std::pair(wave, triangle)}) {
      SCOPED_TRACE(size);
      expect_complete_search(IndexedCurve(first), IndexedCurve(second), 10);
    }
  }
}

class PairWalks : public ::testing::TestWithParam<SceneKind> {
 protected:
  PairWalks() {
    Random random(seed());
    made_ = GetParam().make(random, std::min<std::size_t>(GetParam().largest, 5000));
  }
  Scene made_;
};

// By boxes every two leaves whose boxes meet come out, no others: what holds them meets, too. The trees may be one.
TEST_P(PairWalks, BoxesFindWhatMeets) {
  const BoxTree one{CurveView(made_.first)}, two{CurveView(made_.second)};
  if (one.stalls() || two.stalls()) return;  // there leaves that are points are left out
  const NodeBoxes boxes(one);
  for (const BoxTree* other : {&one, &two}) {
    const NodeBoxes others(*other);
    const NodeLists found = leaves_of(PairWalk(boxes, others), one, *other);
    for (std::uint32_t k = 0; k < one.leaves(); ++k) {
      std::vector<TreeNode> wanted;
      for (std::uint32_t j = 0; j < other->leaves(); ++j) {
        if (meet(one.leaf_boxes()[k], other->leaf_boxes()[j])) wanted.push_back({0, j});
      }
      ASSERT_EQ(found[k], wanted) << k;
    }
    for (std::size_t k = one.leaves(); k < found.size(); ++k) ASSERT_TRUE(found[k].empty()) << k;
  }
}

template <typename Nodes>
void expect_same_in_steps(const PairWalk<Nodes>& walk, const BoxTree& first, const BoxTree& second) {
  const NodeLists at_once = leaves_of(walk, first, second);
  ASSERT_EQ(at_once, leaves_step_by_step(walk, first, second));
  if (!has_avx2()) return;
  const InstructionSet before = instruction_set();
  limit_instruction_set(InstructionSet::baseline);
  const NodeLists baseline = leaves_of(walk, first, second);
  limit_instruction_set(before);
  ASSERT_EQ(at_once, baseline) << "the copies of a kernel should do the same";
}

TEST_P(PairWalks, AllWaysDownLeadToTheSame) {
  const BoxTree one{CurveView(made_.first)}, two{CurveView(made_.second)};
  const NodeBoxes boxes1(one), boxes2(two);
  expect_same_in_steps(PairWalk(boxes1, boxes2), one, two);
  expect_same_in_steps(PairWalk(boxes1), one, one);
  const NodeFrames frames1(one), frames2(two);
  expect_same_in_steps(PairWalk(frames1, frames2), one, two);
  expect_same_in_steps(PairWalk(frames1), one, one);
  const NodeStrips strips1(one), strips2(two);
  expect_same_in_steps(PairWalk(strips1, strips2), one, two);
}
INSTANTIATE_TEST_SUITE_P(Scenes, PairWalks, ::testing::ValuesIn(scene_kinds()),
                         [](const auto& kind) { return std::string(kind.param.name); });

}  // namespace
}  // namespace lober::test
