// Boxes, flags and shoelace sums of leaves, from every compiled copy, against exact arithmetic.
#include "kernels/leaf.hpp"
#include "kernels/kernel_table.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "kernels/box.hpp"
#include "kernels/cpu.hpp"
#include "kernels/kernel_table.hpp"
#include "kernels/simd.hpp"
#include "tests/kernels/random_doubles.hpp"
#include "tests/shapes.hpp"

namespace lober::test {
namespace {

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
    const mpq_class x2 = mpq_class(p[i + 1].x) - mpq_class(p[0].x), y2 = mpq_class(p[i + 1].y) - mpq_class(p[0].y);
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
      for (std::size_t i = 0; i <= leaf_size; ++i) box = union_of(box, Box::of(p[i], p[i]));
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

void expect_bits_of_the_plain_copy(decltype(KernelTable::summarise_leaves) copy) {
  Random random(seed());
  for (int k = 0; k < 3000; ++k) {
    const std::size_t leaves = 1 + random.index(9);
    const Points points = random_points(random, leaves * leaf_size + 1);
    Summary plain(leaves), wide(leaves);
    baseline_kernels.summarise_leaves(points.data(), 0, leaves, plain.boxes.data(), plain.sums.data(),
                                      plain.flags.data());
    copy(points.data(), 0, leaves, wide.boxes.data(), wide.sums.data(), wide.flags.data());
    ASSERT_EQ(std::memcmp(plain.boxes.data(), wide.boxes.data(), leaves * sizeof(Box)), 0) << "try " << k;
    ASSERT_EQ(std::memcmp(plain.sums.data(), wide.sums.data(), leaves * sizeof(DD)), 0) << "try " << k;
    ASSERT_EQ(plain.flags, wide.flags) << "try " << k;
  }
}

TEST(SummariseLeaves, GivesTheSameBitsWithAvx2) {
  if (!has_avx2()) GTEST_SKIP() << "this processor has no AVX2 and FMA";
  expect_bits_of_the_plain_copy(avx2_kernels.summarise_leaves);
}

TEST(SummariseLeaves, GivesTheSameBitsWithAvx512) {
  if (!has_avx512()) GTEST_SKIP() << "this processor has no AVX-512";
  expect_bits_of_the_plain_copy(avx512_kernels.summarise_leaves);
}

// Coordinates that differ by less than a factor two have exact differences, others take another way: the
// border.
TEST(SummariseLeaves, SumsAreRightOnEitherSideOfExactDifferences) {
  Random random(seed());
  for (int k = 0; k < 500; ++k) {
    Points points(leaf_size + 1);
    const double low = random.uniform(1, 2), sign = random.chance(0.5) ? 1 : -1;
    const double high = random.chance(0.5) ? neighbour(2 * low, random.integer(-1, 1)) : random.uniform(1.5, 4) * low;
    for (Point& point : points) point = {sign * random.uniform(low, high), random.uniform(low, high)};
    points[random.index(leaf_size)].x = sign * high;
    points[random.index(leaf_size)].x = sign * low;
    Summary summary(1);
    summarise_leaves(points.data(), 0, 1, summary.boxes.data(), summary.sums.data(), summary.flags.data());
    const mpq_class sum = mpq_class(summary.sums[0].hi) + mpq_class(summary.sums[0].lo);
    ASSERT_TRUE(within(sum, exact_sum(points.data()), -96, mpq_class(2 * (high - low) * (high - low)))) << "try " << k;
  }
}

}  // namespace
}  // namespace lober::test
