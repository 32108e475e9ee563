// Lists of nodes whose boxes meet given ones: both compiled copies against brute force.
#include "kernels/box_pyramid.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "kernels/box.hpp"
#include "kernels/cpu.hpp"
#include "kernels/kernel_table.hpp"
#include "kernels/simd.hpp"
#include "tests/kernels/random_doubles.hpp"
#include "tests/kernels/vector_copies.hpp"

namespace lober::test {
using namespace detail;
namespace {

// A pyramid over random boxes, some of which only touch.
struct Pyramid {
  explicit Pyramid(Random& random) {
    const auto leaves = static_cast<std::uint32_t>(random.integer(1, 70));
    for (std::uint32_t count = leaves;; count = (count + 1) / 2) {
      begin.push_back(static_cast<std::uint32_t>(boxes.size()));
      size.push_back(count);
      for (std::uint32_t k = 0; k < count; ++k) boxes.push_back(begin.size() == 1 ? random_box(random) : united(k));
      if (count == 1) break;
    }
    boxes.resize(boxes.size() + nodes_at_once - 1);
  }
  static Box random_box(Random& random) {
    const auto whole = [&] { return static_cast<double>(random.integer(0, 20)); };
    const Point corner{whole(), whole()};
    return Box::of(corner, {corner.x + random.integer(0, 3), corner.y + random.integer(0, 3)});
  }
  [[nodiscard]] Box united(std::uint32_t k) const {
    const std::uint32_t below = begin[begin.size() - 2] + 2 * k;
    return 2 * k + 1 < size[size.size() - 2] ? union_of(boxes[below], boxes[below + 1]) : boxes[below];
  }
  [[nodiscard]] BoxPyramid view() const { return {boxes.data(), begin.data(), size.data()}; }
  [[nodiscard]] std::vector<TreeNode> some_nodes(Random& random) const {
    std::vector<TreeNode> nodes;
    for (std::uint32_t level = 0; level < size.size(); ++level) {
      for (std::uint32_t k = 0; k < size[level]; ++k) {
        if (random.chance(0.3)) nodes.push_back({level, k});
      }
    }
    return nodes;
  }
  std::vector<Box> boxes;
  std::vector<std::uint32_t> begin, size;
};

using Distribute = decltype(KernelTable::distribute);
using Refine = decltype(&refine);

void check_distribute(Distribute run) {
  Random random(seed());
  for (int k = 0; k < 300; ++k) {
    const Pyramid pyramid(random);
    const std::vector<TreeNode> list = pyramid.some_nodes(random);
    std::array<Box, nodes_at_once> four;
    for (Box& box : four) box = Pyramid::random_box(random);
    const auto boxes = static_cast<std::size_t>(random.integer(1, nodes_at_once));
    std::array<std::vector<TreeNode>, nodes_at_once> met;
    std::array<TreeNode*, nodes_at_once> targets;
    std::array<std::size_t, nodes_at_once> count;
    for (std::size_t i = 0; i < nodes_at_once; ++i) {
      met[i].resize(list.size() + 1);
      targets[i] = met[i].data();
    }
    run(four.data(), boxes, pyramid.view(), list.data(), list.size(), targets.data(), count.data());
    for (std::size_t i = 0; i < nodes_at_once; ++i) {
      std::vector<TreeNode> expected;
      for (const TreeNode& node : list) {
        if (i < boxes && meet(four[i], pyramid.boxes[pyramid.begin[node.level] + node.index])) expected.push_back(node);
      }
      met[i].resize(count[i]);
      ASSERT_TRUE(met[i] == expected) << "try " << k << ", box " << i;
    }
  }
}

void check_refine(Refine run) {
  Random random(seed());
  for (int k = 0; k < 300; ++k) {
    const Pyramid pyramid(random);
    const std::vector<TreeNode> list = pyramid.some_nodes(random);
    const Box box = Pyramid::random_box(random);
    const double largest = random.chance(0.3) ? -1 : random.integer(0, 20);
    std::vector<TreeNode> kept(list.size() + 1), split(4 * list.size() + 1), expected_kept, expected_split;
    const SplitCounts refined = run(box, largest, pyramid.view(), list.data(), list.size(), kept.data(), split.data());
    for (const TreeNode& node : list) {
      const auto box_at = [&](TreeNode at) { return pyramid.boxes[pyramid.begin[at.level] + at.index]; };
      if (node.level == 0 || box_at(node).extent() <= largest) {
        expected_kept.push_back(node);
        continue;
      }
      const std::uint32_t down = std::min(node.level, levels_at_once);
      for (std::uint32_t i = node.index << down; i < (node.index + 1) << down; ++i) {
        const TreeNode below{node.level - down, i};
        if (i < pyramid.size[below.level] && meet(box, box_at(below))) expected_split.push_back(below);
      }
    }
    kept.resize(refined.kept);
    split.resize(refined.split);
    ASSERT_TRUE(kept == expected_kept) << "try " << k;
    ASSERT_TRUE(split == expected_split) << "try " << k;
  }
}

TEST(BoxPyramid, DistributesByTheBoxesThatAreMet) {
  check_distribute(baseline_kernels.distribute);
}
TEST(BoxPyramid, RefinesWhatIsLarge) {
  check_refine(baseline_kernels.refine);
}
TEST(BoxPyramid, TheOtherCopiesToo) {
  if (vector_copies().empty()) GTEST_SKIP() << "this processor has no AVX2 and FMA: only one copy can run";
  for (const KernelTable* copy : vector_copies()) {
    check_distribute(copy->distribute);
    check_refine(copy->refine);
  }
}

}  // namespace
}  // namespace lober::test
