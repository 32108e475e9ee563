// Walks of two trees by pairs of nodes: nothing is lost on the way down, and nothing else comes out.
#include "engine/geometry/index/pair_walk.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "kernels/cpu.hpp"
#include "tests/engine/geometry/index/scenes.hpp"
#include "tests/engine/geometry/index/search_testing.hpp"

namespace lober::test {
using namespace lober::detail;
namespace {

using NodeLists = std::vector<std::vector<TreeNode>>;

// The nodes of even levels at the root or below it.
std::vector<TreeNode> highest(const BoxTree& tree) {
  const TreeNode root = tree.root();
  if (root.level % 2 == 0) return {root};
  return {{root.level - 1, 0}, {root.level - 1, 1}};
}
TreeNode above_all(const BoxTree& tree) {
  return {tree.root().level + tree.root().level % 2, 0};
}

template <typename Nodes>
NodeLists below(const Nodes& first, TreeNode top, std::uint32_t level, const Nodes& second,
                const std::vector<TreeNode>& list) {
  MeetingLists met;
  SearchCounts counts;
  PairWalk(first, second).go_down(top, level, list, met, counts);
  NodeLists lists;
  for (std::uint32_t k = 0; k < met.size(); ++k) {
    lists.emplace_back(met[k].begin(), met[k].end());
    std::sort(lists.back().begin(), lists.back().end(),
              [](TreeNode a, TreeNode b) { return std::pair(a.level, a.index) < std::pair(b.level, b.index); });
  }
  return lists;
}
template <typename Nodes>
NodeLists leaves_of(const Nodes& first, const Nodes& second) {
  return below(first, above_all(first.tree()), 0, second, highest(second.tree()));
}

// Two levels at a time.
template <typename Nodes>
NodeLists leaves_step_by_step(const Nodes& first, const Nodes& second) {
  NodeLists lists{highest(second.tree())};
  for (std::uint32_t level = above_all(first.tree()).level; level > 0; level -= levels_at_once) {
    NodeLists next;
    for (std::uint32_t k = 0; k < lists.size(); ++k) {
      for (auto& list : below(first, {level, k}, level - levels_at_once, second, lists[k])) {
        next.push_back(std::move(list));
      }
    }
    lists = std::move(next);
  }
  return lists;
}

class PairWalks : public ::testing::TestWithParam<SceneKind> {
 protected:
  PairWalks() {
    Random random(seed());
    made_ = GetParam().make(random, std::min<std::size_t>(GetParam().largest, 5000));
  }
  Scene made_;
};

// By boxes every two leaves whose boxes meet come out, no others: what holds them meets, too.
TEST_P(PairWalks, BoxesFindWhatMeets) {
  const BoxTree one{CurveView(made_.first)}, two{CurveView(made_.second)};
  if (one.stalls() || two.stalls()) return;  // there leaves that are points are left out
  const NodeLists found = leaves_of(NodeBoxes(one), NodeBoxes(two));
  for (std::uint32_t k = 0; k < one.leaves(); ++k) {
    std::vector<TreeNode> wanted;
    for (std::uint32_t j = 0; j < two.leaves(); ++j) {
      if (meet(one.leaf_boxes()[k], two.leaf_boxes()[j])) wanted.push_back({0, j});
    }
    ASSERT_EQ(found[k], wanted) << k;
  }
  for (std::size_t k = one.leaves(); k < found.size(); ++k) ASSERT_TRUE(found[k].empty()) << k;
}

template <typename Nodes>
void expect_same_in_steps(const Nodes& first, const Nodes& second) {
  const NodeLists at_once = leaves_of(first, second);
  ASSERT_EQ(at_once, leaves_step_by_step(first, second));
  if (!has_avx2()) return;
  const InstructionSet before = instruction_set();
  limit_instruction_set(InstructionSet::baseline);
  const NodeLists baseline = leaves_of(first, second);
  limit_instruction_set(before);
  ASSERT_EQ(at_once, baseline) << "the copies of a kernel should do the same";
}

TEST_P(PairWalks, AllWaysDownLeadToTheSame) {
  const BoxTree one{CurveView(made_.first)}, two{CurveView(made_.second)};
  const NodeBoxes boxes1(one), boxes2(two);
  expect_same_in_steps(boxes1, boxes2);
  expect_same_in_steps(boxes1, boxes1);
  const NodeFrames frames1(one), frames2(two);
  expect_same_in_steps(frames1, frames2);
  expect_same_in_steps(frames1, frames1);
  expect_same_in_steps(NodeStrips(one), NodeStrips(two));
}
INSTANTIATE_TEST_SUITE_P(Scenes, PairWalks, ::testing::ValuesIn(scene_kinds()),
                         [](const auto& kind) { return std::string(kind.param.name); });

}  // namespace
}  // namespace lober::test
