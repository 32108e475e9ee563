// Single terms of shoelace sums and running sums, against GMP.
#include "kernels/shoelace.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstring>

#include "kernels/cpu.hpp"
#include "kernels/shoelace.inl"
#include "kernels/simd.hpp"
#include "tests/kernels/random_doubles.hpp"

namespace lober {
void shoelace_terms_avx2(const Point* points, Point origin, DD* terms);
}

namespace lober::testing {
namespace {

using Leaf = std::array<Point, leaf_size + 1>;

Leaf random_leaf(Random& random) {
  Leaf leaf;
  const double x = with_exponent(random, -20, 20), y = with_exponent(random, -20, 20),
               size = random.log_uniform(1e-9, 1e3);
  for (Point& point : leaf) point = {x + size * random.uniform(-1, 1), y + size * random.uniform(-1, 1)};
  return leaf;
}

mpq_class value_of(DD a) {
  return mpq_class(a.hi) + mpq_class(a.lo);
}

TEST(Shoelace, KeepsItsBound) {
  Random random(seed());
  for (int k = 0; k < 500; ++k) {
    const Leaf leaf = random_leaf(random);
    const Point origin =
        random.chance(0.5) ? leaf[random.index(leaf.size())] : Point{leaf[0].x + 1, leaf[0].y - 2};
    std::array<DD, leaf_size> terms;
    shoelace_terms(leaf.data(), origin, terms.data());
    for (std::size_t i = 0; i < leaf_size; ++i) {
      const mpq_class ax = mpq_class(leaf[i].x) - mpq_class(origin.x),
                      ay = mpq_class(leaf[i].y) - mpq_class(origin.y);
      const mpq_class bx = mpq_class(leaf[i + 1].x) - mpq_class(origin.x);
      const mpq_class by = mpq_class(leaf[i + 1].y) - mpq_class(origin.y);
      const mpq_class error = value_of(terms[i]) - (ax * by - ay * bx);
      const mpq_class bound = power_of_two(-102);
      ASSERT_LE(error * error, bound * bound * (ax * ax + ay * ay) * (bx * bx + by * by)) << "try " << k;
      const mpq_class single = value_of(shoelace(leaf[i], leaf[i + 1], origin)) - (ax * by - ay * bx);
      ASSERT_LE(single * single, bound * bound * (ax * ax + ay * ay) * (bx * bx + by * by)) << "one at a time, try " << k;
    }
  }
}

TEST(Shoelace, BothCopiesGiveTheSameBits) {
  if (!has_avx2()) GTEST_SKIP() << "this processor has no AVX2 and FMA: only one copy can run";
  Random random(seed());
  for (int k = 0; k < 3000; ++k) {
    const Leaf leaf = random_leaf(random);
    std::array<DD, leaf_size> plain, wide;
    terms_of(leaf.data(), leaf[3], plain.data());
    shoelace_terms_avx2(leaf.data(), leaf[3], wide.data());
    ASSERT_EQ(std::memcmp(plain.data(), wide.data(), sizeof plain), 0) << "try " << k;
  }
}

TEST(RunningSum, KeepsItsBound) {
  Random random(seed());
  for (int k = 0; k < 200; ++k) {
    RunningSum sum;
    mpq_class exact(0), largest(0);
    const int count = random.integer(1, 400);
    const bool cancels = random.chance(0.5);
    DD last;
    for (int i = 0; i < count; ++i) {
      DD term = two_product(with_exponent(random, -10, 10), random.uniform(0.5, 1));
      if (cancels && i % 2 == 1) term = two_diff(random.uniform(0, 1e-9), last.hi);
      last = term;
      sum.add(term);
      exact += value_of(term);
      largest = std::max({largest, mpq_class(abs(exact)), mpq_class(std::fabs(term.hi))});
    }
    ASSERT_TRUE(within(value_of(sum.value()), exact, -106, count * largest)) << "try " << k;
  }
}

}  // namespace
}  // namespace lober::testing
