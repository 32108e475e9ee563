// Sums that short curves keep against those that are made for each pair.
#include "engine/geometry/index/kept_sums.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <set>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/index/box_tree.hpp"
#include "engine/geometry/index/sums_along.hpp"
#include "lober/overlay/overlay.hpp"
#include "tests/engine/geometry/index/scenes.hpp"
#include "tests/engine/geometry/index/search_testing.hpp"
#include "tests/shapes.hpp"

namespace lober::test {
using namespace lober::detail;
namespace {

bool same_bits(DD a, DD b) {
  return std::memcmp(&a, &b, sizeof(DD)) == 0;
}

TEST(KeptSums, HaveTheBitsOfSumsThatAreMadeForOnePair) {
  Random random(seed());
  for (const std::size_t size : {3, 4, 15, 16, 17, 255, 256, 257, 700, 2048}) {
    SCOPED_TRACE(size);
    const Curve curve = random_walk(random, size, true);
    const BoxTree tree{CurveView(curve)};
    const KeptSums kept(tree);
    std::vector<PrecisePosition> positions;
    for (std::uint32_t k = 0; k < size; ++k) {
      const double t = random.unit();
      positions.push_back({k, {t, t * 0x1p-60}});
    }
    const SumAlong along = sum_along(
        tree, curve.points[0], positions.size(), [&](std::size_t k) { return positions[k]; },
        [&](std::size_t k, DD sum) {
          EXPECT_TRUE(same_bits(sum, kept.up_to(positions[k].segment, positions[k].t))) << k;
        });
    EXPECT_TRUE(same_bits(along.total, kept.total()));
  }
}

TEST(KeptSums, BeginWhenAShortCurveHasBeenUsedSeveralTimes) {
  const Points points = circle(KeptSums::max_segments, {0, 0}, 1),
               longer = circle(KeptSums::max_segments + 1, {0, 0}, 1);
  const BoxTree tree{CurveView{points}}, longer_tree{CurveView{longer}};
  EXPECT_EQ(tree.kept_sums(), nullptr);
  std::set<const KeptSums*> seen;
  for (int k = 0; k < 100; ++k) {
    seen.insert(tree.kept_sums());
    EXPECT_EQ(longer_tree.kept_sums(), nullptr);
  }
  EXPECT_EQ(seen.size(), 2U);  // none at first, then always the same
  EXPECT_GE(tree.memory(), longer_tree.memory() + KeptSums::memory(points.size()) / 2);
}

TEST(KeptSums, AreOneForAllThreads) {
  const Points points = circle(2000, {0, 0}, 1);
  for (int round = 0; round < 20; ++round) {
    const BoxTree tree{CurveView{points}};
    std::vector<const KeptSums*> last(8);
    with_threads(7, [&] {
      for_each_block(last.size(), 1, [&](std::size_t k, std::size_t) {
        for (int times = 0; times < 10; ++times) last[k] = tree.kept_sums();
      });
    });
    for (const KeptSums* const one : last) EXPECT_EQ(one, tree.kept_sums());
  }
}

// First vertices that are far apart: sums of either curve are about its own.
TEST(KeptSums, LeaveOverlaysAsTheyAre) {
  const Points first = wavy_circle(700, 0.1, 5), second = wavy_circle(2048, 0.1, 7, 3, {0.4, 0.3});
  const IndexedCurve one{CurveView{first}}, other{CurveView{second}};
  const Overlay fresh = overlay(one, other);
  for (int k = 0; k < 10; ++k) {
    const Overlay again = overlay(one, other);
    EXPECT_EQ(std::memcmp(&again.areas, &fresh.areas, sizeof(Areas)), 0) << k;
    EXPECT_EQ(std::memcmp(&again.rounding, &fresh.rounding, sizeof(Areas)), 0) << k;
  }
  EXPECT_NE(one.tree().kept_sums(), nullptr);
  const Areas& areas = fresh.areas;
  EXPECT_NEAR(areas.c1, areas.c1_minus_c2 + areas.intersection, 4 * fresh.rounding.c1);
  EXPECT_NEAR(areas.c2, areas.c2_minus_c1 + areas.intersection, 4 * fresh.rounding.c2);
}

}  // namespace
}  // namespace lober::test
