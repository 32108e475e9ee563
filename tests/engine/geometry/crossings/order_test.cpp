// Contacts on one segment are brought into order in n log n comparisons, whichever way they come.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "lober/overlay/overlay.hpp"
#include "lober/overlay/regions.hpp"
#include "tests/shapes.hpp"
#include "tests/views.hpp"

namespace lober::test {
using namespace lober::detail;
namespace {

constexpr std::size_t teeth = 40000;  // each crosses the long segment twice

// A bar whose upper side is one segment.
Points bar() {
  return {{-1, -9}, {static_cast<double>(teeth) + 1, -9}, {static_cast<double>(teeth) + 1, 0}, {-1, 0}};
}

// A comb whose teeth reach into the bar; `shuffled`: they are of all heights, so that the search meets them in an order
// that has nothing to do with that along the segment.
Points comb(bool backwards, bool shuffled) {
  Points points;
  for (std::size_t k = 0; k < teeth; ++k) {
    const double x = static_cast<double>(k), depth = shuffled ? 1 + std::fmod(0.6180339887 * x, 1) : 1;
    points.push_back({x + 0.25, 1});
    points.push_back({x + 0.5, -depth});
    points.push_back({x + 0.75, 1});
  }
  points.push_back({static_cast<double>(teeth), 5});
  points.push_back({0, 5});
  if (backwards) std::reverse(points.begin(), points.end());
  return points;
}

// More contacts than one task sorts, from any vertex of either curve on and either way round.
TEST(OrderAlongSecond, AscendsWhereCurvesRunSideBySide) {
  constexpr std::size_t count = 60000;
  const Points first = circle(count, {0, 0}, 1, 0.3 / count), wave = wavy_circle(count, 2e-5, 20000, 0.6 / count);
  for (const std::size_t from : {0UL, 1UL, 29990UL, count - 1}) {
    for (const bool backwards : {false, true}) {
      Points second = wave;
      std::rotate(second.begin(), second.begin() + static_cast<std::ptrdiff_t>(from), second.end());
      if (backwards) second = reversed(second);
      OverlayOptions options;
      options.check_simple = false;
      const Overlay result = overlay(CurveView{first}, CurveView{second}, options);
      ASSERT_EQ(result.nodes.crossings(), 40000U);
      Position before;
      for (std::size_t k = 0; k < result.nodes.size(); ++k) {
        const std::uint32_t node = result.nodes.order2()[k];
        const Position at = result.nodes[node].begin2;
        ASSERT_TRUE(before.segment < at.segment || (before.segment == at.segment && before.t <= at.t))
            << from << ' ' << k;
        ASSERT_EQ(result.nodes.rank2(node), k);
        before = at;
      }
    }
  }
}

TEST(OrderOnSegments, TakesNLogNComparisonsBothWaysRound) {
  const double count = 2 * static_cast<double>(teeth);
  const double allowed = 3 * count * std::log2(count);
  for (const bool backwards : {false, true}) {
    for (const bool shuffled : {false, true}) {
      for (const bool exchanged : {false, true}) {
        const Points first = bar(), second = comb(backwards, shuffled);
        const CurveView c1{exchanged ? second : first}, c2{exchanged ? first : second};
        OverlayOptions options;
        options.check_simple = false;
        const Overlay result = overlay(c1, c2, options);
        ASSERT_EQ(result.nodes.crossings(), 2 * teeth);
        EXPECT_EQ(result.pieces(Pairing::intersection).size(), teeth);
        const auto comparisons = static_cast<double>(result.statistics.counts.comparisons);
        EXPECT_GE(comparisons, count - 1);
        EXPECT_LE(comparisons, allowed) << backwards << shuffled << exchanged;
      }
    }
  }
}

}  // namespace
}  // namespace lober::test
