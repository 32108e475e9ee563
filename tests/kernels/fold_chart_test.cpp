// Heights of leaves in a chart: their bounds hold every point of every segment in the window, and a leaf counts as one
// that rises only if it does.
#include "kernels/fold_chart.hpp"
#include "kernels/kernel_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernels/box.hpp"
#include "kernels/cpu.hpp"
#include "kernels/leaf.hpp"
#include "tests/kernels/random_doubles.hpp"
#include "tests/shapes.hpp"

namespace lober::test {
using namespace lober::detail;
namespace {

FoldChart random_chart(Random& random, double size) {
  const double angle = random.uniform(0, 7);
  FoldChart chart{{size * random.unit(), size * random.unit()}, {std::cos(angle), std::sin(angle)}};
  chart.slope = random.uniform(-4, 4);
  chart.bend = random.uniform(-1, 1) / size;
  chart.shear = random.uniform(-1, 1) / size;
  chart.bow = random.uniform(-1, 1) / size;
  return chart;
}

Points leaf_walk(Random& random, double size) {
  const double step = random.log_uniform(1e-6, 1) * size, spread = random.log_uniform(1e-3, 7);
  const double angle = random.uniform(0, 7);
  Points points{{size * random.unit(), size * random.unit()}};
  while (points.size() <= leaf_size) {
    const double turn = angle + spread * random.uniform(-1, 1), length = random.chance(0.05) ? 0 : step;
    points.push_back({points.back().x + length * std::cos(turn), points.back().y + length * std::sin(turn)});
  }
  return points;
}

struct ChartPosition {
  long double along, height;
};
ChartPosition chart_position(const FoldChart& chart, long double x, long double y) {
  const long double dx = x - chart.at.x, dy = y - chart.at.y;
  const long double u = chart.along.x * dx + chart.along.y * dy, v = chart.along.x * dy - chart.along.y * dx;
  return {u, v + u * (chart.slope + chart.bend * u + chart.shear * v) + chart.bow * v * v};
}

TEST(FoldChart, BoundsHoldEverySegmentInTheWindow) {
  Random random(seed());
  std::size_t inside = 0, whole = 0, rising = 0;
  for (int k = 0; k < 4000; ++k) {
    const double size = random.chance(0.3) ? with_exponent(random, -300, 300) : 1;
    const Points points = leaf_walk(random, size);
    const FoldChart chart = random_chart(random, size);
    const Box box = box_of(points);
    const Point one{size * random.unit(), size * random.unit()}, other{size * random.unit(), size * random.unit()};
    const Box window = random.chance(0.3) ? box : Box::of(one, other);
    ChartedLeaf leaf;
    chart_leaf(points.data(), box, window, chart, leaf);
    bool rises = true, falls = true;
    for (std::size_t i = 0; i < leaf_size; ++i) {
      const Point a = points[i], b = points[i + 1];
      const long double rise = chart_position(chart, b.x, b.y).along - chart_position(chart, a.x, a.y).along;
      rises = rises && rise > 0;
      falls = falls && rise < 0;
      if (!meet(Box::of(a, b), window)) continue;
      ASSERT_TRUE(leaf.is_inside) << "try " << k;
      ++inside;
      for (const long double t : {0.0L, 0.2L, 0.5L, 0.9L, 1.0L}) {
        const ChartPosition at = chart_position(chart, a.x + t * (static_cast<long double>(b.x) - a.x),
                                                a.y + t * (static_cast<long double>(b.y) - a.y));
        ASSERT_LE(leaf.low, at.height) << "try " << k;
        ASSERT_GE(leaf.high, at.height) << "try " << k;
        ASSERT_LE(leaf.left, at.along) << "try " << k;
        ASSERT_GE(leaf.right, at.along) << "try " << k;
      }
    }
    ASSERT_TRUE(rises || !leaf.rises) << "try " << k;
    ASSERT_TRUE(falls || !leaf.falls) << "try " << k;
    whole += window.lane[0] == box.lane[0];
    rising += leaf.rises || leaf.falls;
  }
  EXPECT_GT(inside, 20000U);
  EXPECT_GT(whole, 500U);
  EXPECT_GT(rising, 100U);
}

// Steps along the x axis: what turns back, stands still or goes straight up is not one run.
TEST(FoldChart, OnlyWhatRisesThroughoutRises) {
  const auto charted = [](const Points& points) {
    ChartedLeaf leaf;
    const Box box = box_of(points);
    chart_leaf(points.data(), box, box, {{3, 5}, {1, 0}}, leaf);
    return leaf;
  };
  Points straight(leaf_size + 1);
  for (std::size_t k = 0; k <= leaf_size; ++k) straight[k] = {static_cast<double>(k), k % 2 == 0 ? 0 : 0.25};
  EXPECT_TRUE(charted(straight).rises);
  EXPECT_FALSE(charted(straight).falls);
  Points reversed = straight;
  std::reverse(reversed.begin(), reversed.end());
  EXPECT_TRUE(charted(reversed).falls);
  EXPECT_FALSE(charted(reversed).rises);
  for (std::size_t k = 1; k < leaf_size; ++k) {
    Points points = straight;
    points[k] = points[k - 1];
    EXPECT_FALSE(charted(points).rises) << "a point twice";
    points = straight;
    points[k].x = points[k - 1].x;
    EXPECT_FALSE(charted(points).rises) << "straight up";
    points[k].x = neighbour(points[k].x, 1);
    EXPECT_FALSE(charted(points).rises) << "up, an ulp aside: no longer certain";
    points = straight;
    points[k + 1] = points[k - 1];
    EXPECT_FALSE(charted(points).rises) << "out and back";
    points = straight;
    std::swap(points[k], points[k + 1]);
    EXPECT_FALSE(charted(points).rises) << "a small loop";
  }
  Points turning(leaf_size + 1);  // half a turn exactly: its first and last segments go straight up and down
  for (std::size_t k = 0; k <= leaf_size; ++k) {
    const double angle = 3.141592653589793 * (static_cast<double>(k) / leaf_size);
    turning[k] = {-std::cos(angle), std::sin(angle)};
  }
  turning[1].x = turning[0].x;
  turning[leaf_size].x = turning[leaf_size - 1].x;
  EXPECT_FALSE(charted(turning).rises);
}

TEST(FoldChart, OfNumbersThatOverflowBoundsNothing) {
  Points points(leaf_size + 1, Point{1e300, -1e300});
  points[3] = {-1e300, 1e300};
  ChartedLeaf leaf;
  const Box box = box_of(points);
  for (const FoldChart& chart : {FoldChart{{0, 0}, {1, 0}, 1, 1, 1, 1}, FoldChart{{0, 0}, {1, 0}, 0, 1e250, 0, 0}}) {
    chart_leaf(points.data(), box, box, chart, leaf);
    EXPECT_TRUE(leaf.is_inside);
    EXPECT_TRUE(std::isinf(leaf.low) && std::isinf(leaf.high) && std::isinf(leaf.left) && std::isinf(leaf.right));
    EXPECT_FALSE(leaf.rises || leaf.falls);
  }
}

TEST(FoldChart, AllCopiesGiveTheSame) {
  if (!has_avx2()) GTEST_SKIP() << "this processor has no AVX2 and FMA: only one copy can run";
  Random random(seed());
  for (int k = 0; k < 2000; ++k) {
    const Points points = leaf_walk(random, 1);
    const FoldChart chart = random_chart(random, 1);
    const Box box = box_of(points), window = Box::of({random.unit(), random.unit()}, {random.unit(), random.unit()});
    ChartedLeaf plain, wide;
    for (const Box& part : {box, window}) {
      baseline_kernels.chart_leaf(points.data(), box, part, chart, plain);
      avx2_kernels.chart_leaf(points.data(), box, part, chart, wide);
      ASSERT_EQ(plain.is_inside, wide.is_inside);
      ASSERT_EQ(plain.low, wide.low);
      ASSERT_EQ(plain.high, wide.high);
      ASSERT_EQ(plain.left, wide.left);
      ASSERT_EQ(plain.right, wide.right);
      ASSERT_EQ(plain.rises, wide.rises);
      ASSERT_EQ(plain.falls, wide.falls);
    }
  }
}

}  // namespace
}  // namespace lober::test
