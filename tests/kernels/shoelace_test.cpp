// Single terms of shoelace sums and running sums, against GMP.
#include "kernels/shoelace.hpp"
#include "kernels/kernel_table.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <vector>

#include "kernels/cpu.hpp"
#include "kernels/simd.hpp"
#include "tests/kernels/random_doubles.hpp"
#include "tests/kernels/vector_copies.hpp"

namespace lober::test {
namespace {

using Leaf = std::array<Point, leaf_size + 1>;

Leaf random_leaf(Random& random) {
  Leaf leaf;
  const double x = with_exponent(random, -20, 20), y = with_exponent(random, -20, 20),
               size = random.log_uniform(1e-9, 1e3);
  for (Point& point : leaf) point = {x + size * random.uniform(-1, 1), y + size * random.uniform(-1, 1)};
  return leaf;
}

mpq_class squared(const ExactVector& u) {
  return u.x * u.x + u.y * u.y;
}

// The sum up to the point with parameter t of a segment, one at a time.
DD sum_at(const LeafPrefixes& prefixes, std::size_t segment, DD t) {
  const DD part = t * prefixes.term(segment), start = prefixes.before(segment);
  const DD sum = two_sum(start.hi, part.hi);
  return fast_two_sum(sum.hi, sum.lo + (start.lo + part.lo));
}

TEST(Shoelace, KeepsItsBound) {
  Random random(seed());
  const mpq_class bound = power_of_two(-102) * power_of_two(-102);
  for (int k = 0; k < 1000; ++k) {
    const Leaf leaf = random_leaf(random);
    const Point at = leaf[random.index(leaf.size())];
    const Point origin = random.chance(0.3)   ? at
                         : random.chance(0.5) ? neighbour(random, at, 3)
                                              : Point{at.x + 1, at.y - 2};
    LeafPrefixes prefixes;
    std::array<DD, leaf_size> extra;
    for (DD& value : extra) value = two_product(with_exponent(random, -30, 30), random.uniform(0.5, 1));
    const bool with_extra = random.chance(0.5);
    const DD start = two_product(with_exponent(random, -30, 30), random.uniform(0.5, 1));
    const DD end = shoelace_prefixes(leaf.data(), origin, start, with_extra ? extra.data() : nullptr, prefixes);
    mpq_class sum = value_of(start), largest = abs(sum), worst(0), terms(0), largest_terms(0);
    const auto sum_error = [&](DD found, const mpq_class& exact) {
      worst = std::max(worst, mpq_class(abs(value_of(found) - exact)));
    };
    for (std::size_t i = 0; i < leaf_size; ++i) {
      const ExactVector a = exact_vector(origin, leaf[i]), b = exact_vector(origin, leaf[i + 1]);
      const ExactVector edge = exact_vector(leaf[i], leaf[i + 1]);
      const mpq_class exact = a.x * b.y - a.y * b.x;
      const mpq_class error = value_of(shoelace(leaf[i], leaf[i + 1], origin)) - exact;
      ASSERT_LE(error * error, bound * squared(a) * squared(b)) << "one segment, try " << k;
      const mpq_class term_error = value_of(prefixes.term(i)) - exact;
      ASSERT_LE(term_error * term_error, bound * squared(a) * squared(edge)) << "of a leaf, try " << k;
      sum_error(prefixes.before(i), sum);
      // Sums are joined by columns: parts of up to leaf_size terms count.
      const mpq_class half = mpq_class(random.unit());
      const DD t{half.get_d(), 0};
      sum_error(sum_at(prefixes, i, t), sum + value_of(t) * exact);
      sum += exact;
      terms += exact;
      largest_terms += abs(exact);
      if (with_extra) sum += value_of(extra[i]);
      largest += abs(exact) + (with_extra ? mpq_class(abs(value_of(extra[i]))) : mpq_class(0));
    }
    sum_error(end, sum);
    ASSERT_LE(worst, 40 * power_of_two(-106) * largest) << "sums, try " << k;
    const mpq_class error_of_leaf = abs(value_of(shoelace_of_leaf(leaf.data(), origin)) - terms);
    ASSERT_LE(error_of_leaf, 40 * power_of_two(-106) * largest_terms) << "sum of the leaf, try " << k;
  }
}

TEST(Shoelace, AllCopiesGiveTheSameBits) {
  if (vector_copies().empty()) GTEST_SKIP() << "this processor has no AVX2 and FMA: only one copy can run";
  Random random(seed());
  for (int k = 0; k < 3000; ++k) {
    const Leaf leaf = random_leaf(random);
    std::array<DD, leaf_size> extra;
    for (DD& value : extra) value = {random.unit(), 0};
    LeafPrefixes plain, wide;
    const DD plain_end = baseline_kernels.shoelace_prefixes(leaf.data(), leaf[3], {1, 0}, extra.data(), plain);
    const DD plain_sum = baseline_kernels.shoelace_of_leaf(leaf.data(), leaf[3]);
    for (const KernelTable* copy : vector_copies()) {
      const DD wide_end = copy->shoelace_prefixes(leaf.data(), leaf[3], {1, 0}, extra.data(), wide);
      ASSERT_EQ(std::memcmp(&plain, &wide, sizeof plain), 0) << "try " << k;
      ASSERT_EQ(plain_end.hi, wide_end.hi);
      ASSERT_EQ(plain_end.lo, wide_end.lo);
      const DD wide_sum = copy->shoelace_of_leaf(leaf.data(), leaf[3]);
      ASSERT_EQ(plain_sum.hi, wide_sum.hi);
      ASSERT_EQ(plain_sum.lo, wide_sum.lo);
    }
  }
}

TEST(SumsAt, GivesTheBitsOfOneAtATime) {
  Random random(seed());
  for (int k = 0; k < 2000; ++k) {
    const Leaf leaf = random_leaf(random);
    LeafPrefixes prefixes;
    shoelace_prefixes(leaf.data(), leaf[random.index(leaf.size())], {1, 0}, nullptr, prefixes);
    const std::size_t count = random.index(20);
    std::vector<std::uint32_t> segments(count);
    std::vector<DD> t(count), plain(count + 1, DD{-1, -2}), wide = plain;
    for (std::size_t i = 0; i < count; ++i) {
      segments[i] = static_cast<std::uint32_t>(7 * leaf_size + random.index(leaf_size));
      t[i] = random.chance(0.1) ? DD{} : two_product(random.unit(), random.unit());
    }
    baseline_kernels.sums_at(prefixes, segments.data(), t.data(), count, plain.data());
    if (!vector_copies().empty()) {
      vector_copies().back()->sums_at(prefixes, segments.data(), t.data(), count, wide.data());
    } else {
      wide = plain;
    }
    for (std::size_t i = 0; i < count; ++i) {
      const DD expected = sum_at(prefixes, segments[i] % leaf_size, t[i]);
      for (const DD found : {plain[i], wide[i]}) {
        ASSERT_EQ(found.hi, expected.hi) << "place " << i << " of " << count << ", try " << k;
        ASSERT_EQ(found.lo, expected.lo) << "place " << i << " of " << count << ", try " << k;
      }
    }
    for (const DD behind : {plain[count], wide[count]}) {
      ASSERT_EQ(behind.hi, -1) << "written past the end";
      ASSERT_EQ(behind.lo, -2) << "written past the end";
    }
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
}  // namespace lober::test
