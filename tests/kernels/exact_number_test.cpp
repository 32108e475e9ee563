// Exact arithmetic against GMP.
#include "kernels/exact_number.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/kernels/random_doubles.hpp"

namespace lober::test {
using namespace lober::detail;
namespace {

ExactNumber exact_power_of_two(int exponent) {
  ExactNumber result(1);
  while (exponent != 0) {
    const int step = std::clamp(exponent, -1000, 1000);
    result = result * ExactNumber(std::ldexp(1.0, step));
    exponent -= step;
  }
  return result;
}

// Peels off leading doubles until nothing is left.
mpq_class value_of_number(ExactNumber number) {
  mpq_class result(0);
  for (int k = 0; k < 400 && number.sign() != 0; ++k) {
    const ExactNumber::Scaled rounded = number.rounded();
    result += mpq_class(rounded.scaled.hi) * power_of_two(rounded.exponent);
    number = number - ExactNumber(rounded.scaled.hi) * exact_power_of_two(rounded.exponent);
  }
  EXPECT_EQ(number.sign(), 0);
  return result;
}

double interesting(Random& random) {
  switch (random.integer(0, 4)) {
    case 0:
      return with_exponent(random, -3, 3);
    case 1:
      return static_cast<double>(random.integer(-4, 4));
    case 2:
      return std::ldexp(1.0, random.integer(-1074, 1023)) * (random.chance(0.5) ? 1 : -1);
    case 3:
      return static_cast<double>(random.integer(-3, 3)) * 0x1p-1074;
    default:
      return any_finite(random);
  }
}

TEST(ExactNumber, HoldsEveryFiniteDouble) {
  Random random(seed());
  for (int k = 0; k < 20000; ++k) {
    const double value = interesting(random);
    const ExactNumber number(value);
    ASSERT_EQ(number.sign(), (value > 0) - (value < 0));
    ASSERT_EQ(value_of_number(number), mpq_class(value)) << std::hexfloat << value;
  }
  for (const double value :
       {std::numeric_limits<double>::max(), -std::numeric_limits<double>::max(), 0x1p-1074, 0x1p-1022, 0.0, -0.0}) {
    EXPECT_EQ(value_of_number(ExactNumber(value)), mpq_class(value));
  }
}

TEST(ExactNumber, AddsSubtractsAndMultipliesExactly) {
  Random random(seed());
  for (int k = 0; k < 20000; ++k) {
    const double a = interesting(random),
                 b = random.chance(0.2) ? neighbour(a, random.integer(-1, 1)) : interesting(random);
    const mpq_class exact_a(a), exact_b(b);
    ASSERT_EQ(value_of_number(ExactNumber(a) + ExactNumber(b)), exact_a + exact_b) << std::hexfloat << a << ' ' << b;
    ASSERT_EQ(value_of_number(ExactNumber(a) - ExactNumber(b)), exact_a - exact_b) << std::hexfloat << a << ' ' << b;
    ASSERT_EQ(value_of_number(ExactNumber(a) * ExactNumber(b)), exact_a * exact_b) << std::hexfloat << a << ' ' << b;
    ASSERT_EQ(value_of_number(exact_difference(a, b)), exact_a - exact_b);
  }
}

// The largest and the most scattered numbers that the predicates form: differences of degree four.
TEST(ExactNumber, HoldsPolynomialsOfDegreeFour) {
  Random random(seed());
  const double most = std::numeric_limits<double>::max(), least = 0x1p-1074;
  for (int k = 0; k < 300; ++k) {
    const auto value = [&] {
      switch (random.integer(0, 3)) {
        case 0:
          return most;
        case 1:
          return -most;
        case 2:
          return least * random.integer(1, 3);
        default:
          return any_finite(random);
      }
    };
    ExactNumber total;
    mpq_class exact_total(0);
    for (int term = 0; term < 4; ++term) {
      ExactNumber product(1);
      mpq_class exact_product(1);
      for (int factor = 0; factor < 4; ++factor) {
        const double a = value(), b = value();
        product = product * exact_difference(a, b);
        exact_product *= mpq_class(a) - mpq_class(b);
      }
      total = term % 2 == 0 ? total + product : total - product;
      exact_total += term % 2 == 0 ? exact_product : mpq_class(-exact_product);
      ASSERT_EQ(total.sign(), sgn(exact_total));
    }
    ASSERT_EQ(value_of_number(total), exact_total) << "try " << k;
  }
}

TEST(ExactNumber, RoundsToDoubleDouble) {
  Random random(seed());
  for (int k = 0; k < 20000; ++k) {
    const double a = interesting(random), b = interesting(random), c = interesting(random), d = interesting(random);
    const ExactNumber number = exact_difference(a, b) * exact_difference(c, d);
    const mpq_class exact = (mpq_class(a) - mpq_class(b)) * (mpq_class(c) - mpq_class(d));
    const ExactNumber::Scaled rounded = number.rounded();
    if (exact == 0) {
      ASSERT_EQ(rounded.scaled.hi, 0);
      continue;
    }
    const mpq_class scaled = mpq_class(rounded.scaled.hi) + mpq_class(rounded.scaled.lo);
    ASSERT_TRUE(abs(scaled) >= 1 && abs(scaled) <= 2) << "try " << k;
    ASSERT_TRUE(within(scaled * power_of_two(rounded.exponent), exact, -100, exact)) << "try " << k;
  }
}

TEST(ExactNumber, RatioIsRightToDoubleDouble) {
  Random random(seed());
  for (int k = 0; k < 20000; ++k) {
    const int scale = random.integer(-500, 500);
    const double a = with_exponent(random, scale - 60, scale + 60), b = with_exponent(random, scale - 60, scale + 60);
    const double c = with_exponent(random, scale - 60, scale + 60), d = with_exponent(random, scale - 60, scale + 60);
    const mpq_class exact = (mpq_class(a) - mpq_class(b)) / (mpq_class(c) - mpq_class(d));
    const DD ratio = exact_ratio(exact_difference(a, b), exact_difference(c, d));
    ASSERT_TRUE(within(mpq_class(ratio.hi) + mpq_class(ratio.lo), exact, -98, exact)) << "try " << k;
  }
}

}  // namespace
}  // namespace lober::test
