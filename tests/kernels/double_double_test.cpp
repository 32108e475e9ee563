// The error bounds that kernels/double_double.hpp states, against GMP, and vector code against scalar code.
#include "kernels/double_double.hpp"

#include <gtest/gtest.h>

#include "tests/kernels/random_doubles.hpp"

namespace lober::test {
using namespace lober::detail;
namespace {

// Multiples of u^2, u = 2^-53.
mpq_class u_squared(int count) {
  return count * power_of_two(-106);
}

// A double-double whose low part is anywhere, most often as large as it may be.
DD random_dd(Random& random, int spread) {
  double hi = with_exponent(random, -spread, spread);
  if (random.chance(0.3))
    hi = std::ldexp(random.chance(0.5) ? 1 + 0x1p-52 * random.integer(0, 9) : 2 - 0x1p-52 * random.integer(1, 9),
                    random.integer(-spread, spread));
  int exponent = 0;
  std::frexp(hi, &exponent);
  const double half_ulp = std::ldexp(1.0, exponent - 54);
  const double part = random.chance(0.5) ? 1 - random.unit() * 1e-3 : random.log_uniform(1e-20, 1);
  return fast_two_sum(hi, half_ulp * part * (random.chance(0.5) ? 1 : -1));
}

// Close to -a, so that a sum cancels.
DD nearly_opposite(Random& random, DD a) {
  const double lo = random.chance(0.5) ? -a.lo : a.lo * random.uniform(-1, 1);
  return fast_two_sum(random.chance(0.5) ? -a.hi : -neighbour(a.hi, random.integer(-2, 2)), lo);
}

bool normalised(DD a) {
  return a.hi + a.lo == a.hi;
}

TEST(DoubleDouble, TransformsAreExact) {
  Random random(seed());
  for (int k = 0; k < 100000; ++k) {
    const int spread = random.chance(0.5) ? 3 : 200;
    const double a = with_exponent(random, -spread, spread), b = with_exponent(random, -spread, spread);
    ASSERT_EQ(value_of(two_sum(a, b)), mpq_class(a) + mpq_class(b));
    ASSERT_EQ(value_of(two_diff(a, b)), mpq_class(a) - mpq_class(b));
    ASSERT_EQ(value_of(two_product(a, b)), mpq_class(a) * mpq_class(b));
    const double large = std::max(std::fabs(a), std::fabs(b)), small = std::min(std::fabs(a), std::fabs(b));
    ASSERT_EQ(value_of(fast_two_sum(large, -small)), mpq_class(large) - mpq_class(small));
    for (const DD result : {two_sum(a, b), two_diff(a, b), two_product(a, b)}) ASSERT_TRUE(normalised(result));
  }
}

TEST(DoubleDouble, OperationsKeepTheirBounds) {
  Random random(seed());
  const mpq_class sum_bound = u_squared(3) + 13 * power_of_two(-159);
  for (int k = 0; k < 150000; ++k) {
    const int spread = random.chance(0.6) ? 1 : 60;
    const DD a = random_dd(random, spread);
    const DD b = random.chance(0.3) ? nearly_opposite(random, a) : random_dd(random, spread);
    const mpq_class exact_a = value_of(a), exact_b = value_of(b);
    const auto right = [](DD result, const mpq_class& exact, const mpq_class& bound) {
      return normalised(result) && abs(mpq_class(value_of(result) - exact)) <= bound * abs(exact);
    };
    ASSERT_TRUE(right(a + b, exact_a + exact_b, sum_bound)) << "try " << k;
    ASSERT_TRUE(right(a - b, exact_a - exact_b, sum_bound)) << "try " << k;
    ASSERT_TRUE(right(a * b, exact_a * exact_b, u_squared(5))) << "try " << k;
    if (b.hi != 0) {
      ASSERT_TRUE(right(a / b, exact_a / exact_b, u_squared(10))) << "try " << k;
    }
    DD accumulated = a;
    accumulated += b;
    ASSERT_EQ(value_of(accumulated), value_of(a + b));
    accumulated = a;
    accumulated -= b;
    ASSERT_EQ(value_of(accumulated), value_of(a - b));
    ASSERT_EQ(value_of(-a), -exact_a);
  }
}

TEST(DoubleDouble, CrossKeepsItsBound) {
  Random random(seed());
  for (int k = 0; k < 50000; ++k) {
    const int spread = random.chance(0.6) ? 1 : 40;
    const DD ux = random_dd(random, spread), uy = random_dd(random, spread), vx = random_dd(random, spread);
    DD vy = random_dd(random, spread);
    if (random.chance(0.5)) vy = uy * vx / ux;  // parallel but for rounding
    const mpq_class left = value_of(ux) * value_of(vy), right = value_of(uy) * value_of(vx);
    const mpq_class bound = u_squared(12) * (abs(left) + abs(right));
    ASSERT_LE(abs(mpq_class(value_of(cross(ux, uy, vx, vy)) - (left - right))), bound) << "try " << k;
  }
}

// Every lane goes through the same roundings as a double does.
TEST(DoubleDouble, LanesGiveTheBitsOfScalars) {
  Random random(seed());
  for (int k = 0; k < 20000; ++k) {
    DD a[lanes], b[lanes];
    BasicDD<Lanes> wide_a, wide_b;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      a[lane] = random_dd(random, 30);
      b[lane] = random.chance(0.3) ? nearly_opposite(random, a[lane]) : random_dd(random, 30);
      wide_a.hi[lane] = a[lane].hi;
      wide_a.lo[lane] = a[lane].lo;
      wide_b.hi[lane] = b[lane].hi;
      wide_b.lo[lane] = b[lane].lo;
    }
    const auto same = [&](const BasicDD<Lanes>& wide, auto&& scalar) {
      bool all = true;
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        const DD expected = scalar(a[lane], b[lane]);
        all = all && std::bit_cast<std::uint64_t>(wide.hi[lane]) == std::bit_cast<std::uint64_t>(expected.hi) &&
              std::bit_cast<std::uint64_t>(wide.lo[lane]) == std::bit_cast<std::uint64_t>(expected.lo);
      }
      return all;
    };
    ASSERT_TRUE(same(wide_a + wide_b, [](DD x, DD y) { return x + y; }));
    ASSERT_TRUE(same(wide_a - wide_b, [](DD x, DD y) { return x - y; }));
    ASSERT_TRUE(same(wide_a * wide_b, [](DD x, DD y) { return x * y; }));
    ASSERT_TRUE(same(wide_a / wide_b, [](DD x, DD y) { return x / y; }));
    ASSERT_TRUE(same(two_sum(wide_a.hi, wide_b.lo), [](DD x, DD y) { return two_sum(x.hi, y.lo); }));
    ASSERT_TRUE(same(two_product(wide_a.hi, wide_b.hi), [](DD x, DD y) { return two_product(x.hi, y.hi); }));
  }
}

}  // namespace
}  // namespace lober::test
