// Pairs of nodes whose boxes meet: all compiled copies against brute force.
#include "kernels/box_pyramid.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "kernels/box.hpp"
#include "kernels/kernel_table.hpp"
#include "kernels/simd.hpp"
#include "tests/kernels/random_doubles.hpp"
#include "tests/kernels/vector_copies.hpp"

namespace lober::test {
using namespace detail;
namespace {

// Random boxes, some of which only touch.
struct Level {
  explicit Level(Random& random) : nodes(static_cast<std::uint32_t>(random.integer(1, 30))) {
    for (std::uint32_t k = 0; k < nodes; ++k) {
      const auto whole = [&](int most) { return static_cast<double>(random.integer(0, most)); };
      const Point corner{whole(20), whole(20)};
      boxes.push_back(Box::of(corner, {corner.x + whole(8), corner.y + whole(8)}));
    }
    // Boxes behind the last one meet everything, and are not there.
    boxes.resize(nodes + nodes_at_once - 1, Box::of({-100, -100}, {100, 100}));
  }
  [[nodiscard]] BoxLevel view() const { return {boxes.data(), nodes}; }
  // The number of nodes two levels above.
  [[nodiscard]] std::uint32_t above() const { return (nodes + 3) / 4; }
  std::uint32_t nodes;
  std::vector<Box> boxes;
};

using PairsBelow = decltype(KernelTable::boxes_below_first);

void check_pairs(PairsBelow run, bool splits_first) {
  Random random(seed());
  for (int k = 0; k < 1000; ++k) {
    const Level first(random), second(random);
    std::vector<NodePair> pairs;
    for (std::uint32_t i = 0; i < (splits_first ? first.above() : first.nodes); ++i) {
      for (std::uint32_t j = 0; j < (splits_first ? second.nodes : second.above()); ++j) {
        if (random.chance(0.3)) pairs.push_back({i, j});
      }
    }
    const Keep keep = std::vector{Keep::all, Keep::none, Keep::level}[static_cast<std::size_t>(random.integer(0, 2))];
    std::vector<NodePair> kept(4 * pairs.size() + 4), split(4 * pairs.size() + 4), expected_kept, expected_split;
    const SplitCounts found =
        run(first.view(), second.view(), pairs.data(), pairs.size(), keep, kept.data(), split.data());
    for (const NodePair pair : pairs) {
      for (std::uint32_t below = 0; below < nodes_at_once; ++below) {
        const std::uint32_t i = splits_first ? 4 * pair.first + below : pair.first;
        const std::uint32_t j = splits_first ? pair.second : 4 * pair.second + below;
        if (i >= first.nodes || j >= second.nodes || !meet(first.boxes[i], second.boxes[j])) continue;
        const bool is_kept =
            keep == Keep::all || (keep == Keep::level && second.boxes[j].extent() <= first.boxes[i].extent());
        (is_kept ? expected_kept : expected_split).push_back({i, j});
      }
    }
    kept.resize(found.kept);
    split.resize(found.split);
    ASSERT_EQ(kept, expected_kept) << "try " << k;
    ASSERT_EQ(split, expected_split) << "try " << k;
  }
}
void check_table(const KernelTable& table) {
  check_pairs(table.boxes_below_first, true);
  check_pairs(table.boxes_below_second, false);
}

TEST(BoxPyramid, FindsPairsBelow) {
  check_table(baseline_kernels);
}
TEST(BoxPyramid, TheOtherCopiesToo) {
  if (vector_copies().empty()) GTEST_SKIP() << "this processor has no AVX2 and FMA: only one copy can run";
  for (const KernelTable* copy : vector_copies()) check_table(*copy);
}

}  // namespace
}  // namespace lober::test
