// Slabs that bend with a leaf: they lose nothing that meets, and part arcs side by side.
#include "kernels/bent_slab.hpp"
#include "kernels/kernel_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "kernels/box.hpp"
#include "kernels/cpu.hpp"
#include "kernels/predicates.hpp"
#include "tests/kernels/random_doubles.hpp"
#include "tests/kernels/vector_copies.hpp"
#include "tests/shapes.hpp"

namespace lober::test {
using namespace lober::detail;
namespace {

// Points along an arc that turns by up to a full turn, off it by up to `thickness`.
Points bent_leaf(Random& random, double size, double thickness, Point centre, double turn) {
  const double begin = random.uniform(0, 7), radius = size / std::max(turn, 0.01);
  Points points(leaf_size + 1);
  for (std::size_t k = 0; k <= leaf_size; ++k) {
    const double angle = begin + turn * static_cast<double>(k) / leaf_size;
    const double r = radius + size * thickness * random.uniform(-1, 1);
    points[k] = {centre.x + r * std::cos(angle), centre.y + r * std::sin(angle)};
  }
  return points;
}

bool arcs_meet(Point a, Point b, Point c, Point d) {
  PredicateCounts counts;
  return meet(Box::of(a, b), Box::of(c, d)) && orient2d(a, b, c, counts) * orient2d(a, b, d, counts) <= 0 &&
         orient2d(c, d, a, counts) * orient2d(c, d, b, counts) <= 0;
}

TEST(BentSlab, LosesNothing) {
  Random random(seed());
  std::size_t common = 0, told_apart = 0;
  for (int k = 0; k < 6000; ++k) {
    const double size = random.chance(0.2) ? with_exponent(random, -500, 500) : 1;
    const double thickness = random.log_uniform(1e-17, 1e-1), turn = random.log_uniform(1e-3, 6);
    const Point centre{random.uniform(-1, 1) * size, random.uniform(-1, 1) * size};
    const Points a = bent_leaf(random, size, thickness, centre, turn);
    Points b = random.chance(0.3) ? bent_leaf(random, size, thickness, centre, turn) : a;
    for (Point& point : b) {
      if (random.chance(0.5)) point = neighbour(random, point, 3);
    }
    const double off = random.chance(0.5) ? random.log_uniform(1e-17, 1e-1) * size : 0;  // off to one side
    for (Point& point : b) point = {point.x + off, point.y};
    if (random.chance(0.2)) std::fill(b.begin() + 20, b.end(), b[20]);
    BentSlab slab;
    bent_slab(a.data(), slab);
    const std::uint32_t kept = segments_meeting(slab, b.data()), own = segments_meeting(slab, a.data());
    EXPECT_EQ(own, ~std::uint32_t{0});
    for (std::uint32_t j = 0; j < leaf_size; ++j) {
      told_apart += ~kept >> j & 1;
      for (std::uint32_t i = 0; i < leaf_size; ++i) {
        if (!arcs_meet(a[i], a[i + 1], b[j], b[j + 1])) continue;
        ++common;
        ASSERT_TRUE(kept >> j & 1) << "try " << k;
      }
    }
  }
  EXPECT_GT(common, 10000U);
  EXPECT_GT(told_apart, 10000U);
}

// Concentric arcs, a thousandth of the height of the arc apart.
TEST(BentSlab, TellsArcsApart) {
  Random random(seed());
  for (const double turn : {0.5, 0.1, 0.02}) {
    const double begin = random.uniform(0, 7), height = turn * turn / 8;
    Points arcs[3];
    for (int which = 0; which < 3; ++which) {
      for (std::size_t k = 0; k <= leaf_size; ++k) {
        const double r = 1 + (which - 1) * 0.05 * height, angle = begin + turn * static_cast<double>(k) / leaf_size;
        arcs[which].push_back({r * std::cos(angle), r * std::sin(angle)});
      }
    }
    BentSlab slab;
    bent_slab(arcs[1].data(), slab);
    EXPECT_EQ(segments_meeting(slab, arcs[0].data()), 0U) << turn;
    EXPECT_EQ(segments_meeting(slab, arcs[2].data()), 0U) << turn;
  }
}

// A curve that goes on from the end of a leaf lies in the slab round it but for its ends: only its first segment
// reaches back, and none does from behind a gap.
TEST(BentSlab, EndsWithTheLeaf) {
  for (const double gap : {0.0, 1e-9}) {
    for (const double bend : {0.0, 0.3}) {
      Points a, b;
      for (std::size_t k = 0; k <= leaf_size; ++k) {
        const double s = static_cast<double>(k) / leaf_size, t = 1 + gap + s;
        a.push_back({0.8 * s - 0.6 * bend * s * s, 0.6 * s + 0.8 * bend * s * s});
        b.push_back({0.8 * t - 0.6 * bend * t * t, 0.6 * t + 0.8 * bend * t * t});
      }
      BentSlab slab;
      bent_slab(a.data(), slab);
      EXPECT_EQ(segments_meeting(slab, b.data()), gap == 0 ? 1U : 0U) << bend;
      std::reverse(b.begin(), b.end());
      EXPECT_EQ(segments_meeting(slab, b.data()), gap == 0 ? 1U << 31U : 0U) << bend;
    }
  }
}

// Segments across the end of a leaf that meet it there: rounding puts the ends of some beyond that of the slab.
TEST(BentSlab, KeepsWhatMeetsItsEnds) {
  Random random(seed());
  std::size_t common = 0;
  for (int k = 0; k < 20000; ++k) {
    const double turn = random.log_uniform(1e-3, 2), size = random.chance(0.2) ? with_exponent(random, -400, 400) : 1;
    const Points a = bent_leaf(random, size, 1e-17, {random.uniform(-1, 1) * size, random.uniform(-1, 1) * size}, turn);
    BentSlab slab;
    bent_slab(a.data(), slab);
    const bool at_front = random.chance(0.5);
    const Point end = at_front ? a.front() : a.back(), before = at_front ? a[1] : a[leaf_size - 1];
    Points b(leaf_size + 1);
    for (std::size_t i = 0; i <= leaf_size; ++i) {
      const double far = (i % 2 == 0 ? 1 : -1) * random.log_uniform(1e-3, 1);
      b[i] = neighbour(random, {end.x - far * slab.along.y, end.y + far * slab.along.x}, 1);
    }
    const std::uint32_t kept = segments_meeting(slab, b.data());
    for (std::size_t j = 0; j < leaf_size; ++j) {
      if (!arcs_meet(before, end, b[j], b[j + 1])) continue;
      ++common;
      ASSERT_TRUE(kept >> j & 1) << "try " << k;
    }
  }
  EXPECT_GT(common, 10000U);
}

TEST(BentSlab, OfNumbersThatOverflowPartsNothing) {
  for (const double size : {1e155, 1e200, 1e308}) {
    Points a(leaf_size + 1), b(leaf_size + 1);
    for (std::size_t k = 0; k <= leaf_size; ++k) {
      const double s = static_cast<double>(k) / leaf_size;
      a[k] = {size * (s - 0.5), size * s * s};
      b[k] = {size * (s - 0.5), size * (0.5 - s)};
    }
    BentSlab slab;
    bent_slab(a.data(), slab);
    for (std::uint32_t j = 0; j < leaf_size; ++j) {
      for (std::uint32_t i = 0; i < leaf_size; ++i) {
        if (!arcs_meet(a[i], a[i + 1], b[j], b[j + 1])) continue;
        EXPECT_TRUE(segments_meeting(slab, b.data()) >> j & 1) << size;
      }
    }
  }
}

TEST(BentSlab, AllCopiesGiveTheSame) {
  if (vector_copies().empty()) GTEST_SKIP() << "this processor has no AVX2 and FMA: only one copy can run";
  Random random(seed());
  for (int k = 0; k < 2000; ++k) {
    const double turn = random.log_uniform(1e-3, 6);
    const Points a = bent_leaf(random, 1, 1e-3, {0, 0}, turn), b = bent_leaf(random, 1, 1e-3, {0, 0}, turn);
    BentSlab plain, wide;
    baseline_kernels.bent_slab(a.data(), plain);
    for (const KernelTable* copy : vector_copies()) {
      copy->bent_slab(a.data(), wide);
      ASSERT_EQ(std::memcmp(&plain, &wide, sizeof plain), 0);
      ASSERT_EQ(baseline_kernels.segments_meeting(plain, b.data()), copy->segments_meeting(plain, b.data()));
    }
  }
}

}  // namespace
}  // namespace lober::test
