// Boxes, flags and shoelace sums of leaves, from both compiled copies, against exact arithmetic.
#include "kernels/leaf.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "kernels/cpu.hpp"
#include "kernels/leaf.inl"
#include "kernels/simd.hpp"
#include "tests/kernels/random_doubles.hpp"

namespace lober {
void summarise_leaves_avx2(const Point* points, std::size_t first, std::size_t count, Box* boxes, DD* sums,
                           std::uint8_t* flags);
}

namespace lober::testing {
namespace {

using Points = std::vector<Point>;

Points random_points(Random& random, std::size_t count) {
  Points points(count);
  const int kind = random.integer(0, 7);
  const double angle = random.uniform(0, 6), step = random.log_uniform(1e-7, 1e-1);
  for (std::size_t k = 0; k < count; ++k) {
    const double t = static_cast<double>(k) * step + angle;
    switch (kind) {
      case 0:
        points[k] = {random.uniform(-1, 1), random.uniform(-1, 1)};
        break;
      case 1:
        points[k] = {std::cos(t), std::sin(t)};
        break;
      case 2:
        points[k] = {1e6 + std::cos(t), 1e6 + std::sin(t)};
        break;
      case 3:
        points[k] = {static_cast<double>(k), static_cast<double>(k * k)};
        break;
      case 4:
        points[k] = {-3.0 * static_cast<double>(k), 2.0 - t};
        break;
      case 5:
        points[k] = {static_cast<double>(random.integer(-2, 2)), static_cast<double>(random.integer(4, 8))};
        break;
      case 6:
        points[k] = {with_exponent(random, -30, 30), with_exponent(random, -30, 30)};
        break;
      default:
        points[k] = k > 0 && random.chance(0.3) ? points[k - 1] : Point{1 + random.unit() * 1e-9, t};
        break;
    }
  }
  return points;
}

struct Summary {
  explicit Summary(std::size_t leaves) : boxes(leaves), sums(leaves), flags(leaves) {}
  std::vector<Box> boxes;
  std::vector<DD> sums;
  std::vector<std::uint8_t> flags;
};

mpq_class exact_sum(const Point* p) {
  mpq_class total(0);
  for (std::size_t i = 1; i < leaf_size; ++i) {
    const mpq_class x1 = mpq_class(p[i].x) - mpq_class(p[0].x), y1 = mpq_class(p[i].y) - mpq_class(p[0].y);
    const mpq_class x2 = mpq_class(p[i + 1].x) - mpq_class(p[0].x),
                    y2 = mpq_class(p[i + 1].y) - mpq_class(p[0].y);
    total += x1 * y2 - x2 * y1;
  }
  return total;
}

TEST(SummariseLeaves, EqualsBruteForce) {
  Random random(seed());
  for (int k = 0; k < 600; ++k) {
    const std::size_t leaves = 1 + random.index(9), first = random.index(leaves);
    const Points points = random_points(random, leaves * leaf_size + 1);
    Summary summary(leaves);
    summarise_leaves(points.data(), first, leaves - first, summary.boxes.data(), summary.sums.data(),
                     summary.flags.data());
    for (std::size_t leaf = first; leaf < leaves; ++leaf) {
      const Point* p = points.data() + leaf * leaf_size;
      Box box;
      unsigned flags = 15;
      for (std::size_t i = 0; i <= leaf_size; ++i) box = unite(box, Box::of(p[i], p[i]));
      for (std::size_t i = 0; i < leaf_size; ++i) {
        if (!(p[i + 1].x > p[i].x)) flags &= ~1U;
        if (!(p[i + 1].y > p[i].y)) flags &= ~2U;
        if (!(p[i + 1].x < p[i].x)) flags &= ~4U;
        if (!(p[i + 1].y < p[i].y)) flags &= ~8U;
      }
      for (std::size_t lane = 0; lane < 4; ++lane) ASSERT_EQ(summary.boxes[leaf].lane[lane], box.lane[lane]);
      ASSERT_EQ(summary.flags[leaf], flags) << "try " << k;
      const mpq_class sum = mpq_class(summary.sums[leaf].hi) + mpq_class(summary.sums[leaf].lo);
      const mpq_class width(box.width()), height(box.height());
      ASSERT_TRUE(within(sum, exact_sum(p), -96, width * width + height * height)) << "try " << k;
    }
  }
}

TEST(SummariseLeaves, BothCopiesGiveTheSameBits) {
  if (!has_avx2()) GTEST_SKIP() << "this processor has no AVX2 and FMA: only one copy can run";
  Random random(seed());
  for (int k = 0; k < 3000; ++k) {
    const std::size_t leaves = 1 + random.index(9);
    const Points points = random_points(random, leaves * leaf_size + 1);
    Summary plain(leaves), wide(leaves);
    summarise(points.data(), 0, leaves, plain.boxes.data(), plain.sums.data(), plain.flags.data());
    summarise_leaves_avx2(points.data(), 0, leaves, wide.boxes.data(), wide.sums.data(), wide.flags.data());
    ASSERT_EQ(std::memcmp(plain.boxes.data(), wide.boxes.data(), leaves * sizeof(Box)), 0) << "try " << k;
    ASSERT_EQ(std::memcmp(plain.sums.data(), wide.sums.data(), leaves * sizeof(DD)), 0) << "try " << k;
    ASSERT_EQ(plain.flags, wide.flags) << "try " << k;
  }
}

// Coordinates that differ by less than a factor two have exact differences, others take another way: the
// border.
TEST(SummariseLeaves, SumsAreRightOnEitherSideOfExactDifferences) {
  Random random(seed());
  for (int k = 0; k < 500; ++k) {
    Points points(leaf_size + 1);
    const double top = neighbour(2.0, random.integer(-1, 1)), sign = random.chance(0.5) ? 1 : -1;
    for (Point& point : points) point = {sign * random.uniform(1, 2), random.uniform(1, 2)};
    points[random.index(leaf_size)].x = sign * top;
    points[random.index(leaf_size)].x = sign * 1.0;
    Summary summary(1);
    summarise_leaves(points.data(), 0, 1, summary.boxes.data(), summary.sums.data(), summary.flags.data());
    ASSERT_TRUE(within(mpq_class(summary.sums[0].hi) + mpq_class(summary.sums[0].lo),
                       exact_sum(points.data()), -96, 2));
  }
}

}  // namespace
}  // namespace lober::testing
