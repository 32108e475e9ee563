// Elementary functions against MPFR.
#include "kernels/elementary.hpp"

#include <gtest/gtest.h>
#include <mpfr.h>

#include <cmath>
#include <limits>
#include <random>

namespace lober::detail {
namespace {

using Function = double (*)(double);
using Exact = int (*)(mpfr_t, const mpfr_t, mpfr_rnd_t);

// Distance of a value from the exact one, in units in the last place of that.
double ulps(double value, const mpfr_t exact) {
  mpfr_t off;
  mpfr_init2(off, 300);
  mpfr_sub_d(off, exact, value, MPFR_RNDN);
  const double rounded = std::fabs(mpfr_get_d(exact, MPFR_RNDN));
  const double ulp = std::nextafter(rounded, std::numeric_limits<double>::infinity()) - rounded;
  const double result = std::fabs(mpfr_get_d(off, MPFR_RNDN)) / ulp;
  mpfr_clear(off);
  return result;
}

double worst_of(Function function, Exact exact_function, double low, double high, bool logarithmic, double offset = 0) {
  std::mt19937_64 random(20261125);
  std::uniform_real_distribution<double> even(logarithmic ? std::log(low) : low, logarithmic ? std::log(high) : high);
  mpfr_t x, exact;
  mpfr_init2(x, 300);
  mpfr_init2(exact, 300);
  double worst = 0;
  for (int k = 0; k < 20'000; ++k) {
    const double at = offset + (logarithmic ? std::exp(even(random)) : even(random));
    mpfr_set_d(x, at, MPFR_RNDN);
    exact_function(exact, x, MPFR_RNDN);
    worst = std::max(worst, ulps(function(at), exact));
  }
  mpfr_clear(x);
  mpfr_clear(exact);
  return worst;
}

TEST(Elementary, AreRightToTheLastPlace) {
  using namespace elementary;
  EXPECT_LT(worst_of(exp, mpfr_exp, -700, 700, false), 1);
  EXPECT_LT(worst_of(exp, mpfr_exp, -1, 1, false), 1);
  EXPECT_LT(worst_of(expm1, mpfr_expm1, -3, 3, false), 3.5);
  EXPECT_LT(worst_of(expm1, mpfr_expm1, 1e-12, 1e-2, true), 2);
  EXPECT_LT(worst_of(log, mpfr_log, 1e-300, 1e300, true), 1);
  EXPECT_LT(worst_of(log, mpfr_log, 0.5, 2, false), 1);
  EXPECT_LT(worst_of(log, mpfr_log, 1e-12, 1e-4, true, 1), 1);
  EXPECT_LT(worst_of(log1p, mpfr_log1p, 1e-15, 1e6, true), 2);
  EXPECT_LT(worst_of(log1p, mpfr_log1p, -0.999, 0.5, false), 2);
  EXPECT_LT(worst_of(log10, mpfr_log10, 1e-300, 1e300, true), 2);
  EXPECT_LT(worst_of(cbrt, mpfr_cbrt, 1e-12, 1e12, true), 1);
  EXPECT_LT(worst_of(atan, mpfr_atan, 1e-12, 1e12, true), 1.5);
  EXPECT_LT(worst_of(atan, mpfr_atan, -2, 2, false), 1.5);
  EXPECT_LT(worst_of(asin, mpfr_asin, -1, 1, false), 3);
}

TEST(Elementary, SinesAndCosines) {
  mpfr_t x, exact;
  mpfr_init2(x, 300);
  mpfr_init2(exact, 300);
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> even(-1e4, 1e4);
  for (int k = 0; k < 20'000; ++k) {
    const double at = even(random);
    mpfr_set_d(x, at, MPFR_RNDN);
    mpfr_sin(exact, x, MPFR_RNDN);
    EXPECT_LT(ulps(elementary::sin(at), exact), 2.5) << at;
    mpfr_cos(exact, x, MPFR_RNDN);
    EXPECT_LT(std::fabs(elementary::cos(at) - mpfr_get_d(exact, MPFR_RNDN)), 5e-16) << at;
  }
  mpfr_clear(x);
  mpfr_clear(exact);
}

TEST(Elementary, AnglesInAllQuadrants) {
  mpfr_t x, y, exact;
  mpfr_init2(x, 300);
  mpfr_init2(y, 300);
  mpfr_init2(exact, 300);
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> even(-1, 1), exponent(-300, 300);
  double worst = 0;
  for (int k = 0; k < 40'000; ++k) {
    const double scale = k % 2 == 0 ? 1 : std::exp2(exponent(random));
    const double a = even(random) * scale, b = even(random) * (k % 4 < 2 ? scale : std::exp2(exponent(random)));
    mpfr_set_d(x, a, MPFR_RNDN);
    mpfr_set_d(y, b, MPFR_RNDN);
    mpfr_atan2(exact, y, x, MPFR_RNDN);
    worst = std::max(worst, ulps(elementary::atan2(b, a), exact));
  }
  EXPECT_LT(worst, 1.5);
  constexpr double inf = std::numeric_limits<double>::infinity();
  for (const double a : {0.0, -0.0, 1.0, -1.0, inf, -inf, 1e-320, -1e-320, 1e308, -1e308}) {
    for (const double b : {0.0, -0.0, 1.0, -1.0, inf, -inf, 1e-320, -1e-320, 1e308, -1e308}) {
      EXPECT_NEAR(elementary::atan2(b, a), std::atan2(b, a), 4e-16 * std::fabs(std::atan2(b, a))) << b << ", " << a;
      EXPECT_EQ(std::signbit(elementary::atan2(b, a)), std::signbit(std::atan2(b, a))) << b << ", " << a;
    }
  }
  mpfr_clear(x);
  mpfr_clear(y);
  mpfr_clear(exact);
}

TEST(Elementary, BesselFunctions) {
  mpfr_t term, square, sum;
  for (mpfr_ptr number : {mpfr_ptr(term), mpfr_ptr(square), mpfr_ptr(sum)}) mpfr_init2(number, 300);
  double worst = 0;
  for (const int n : {0, 1, 2, 5, 12, 29}) {
    for (double x = 0.01; x < 30; x *= 1.37) {
      // (x / 2)^n / n! times the sum of (x^2 / 4)^k n! / (k! (n + k)!).
      mpfr_set_d(square, x, MPFR_RNDN);
      mpfr_sqr(square, square, MPFR_RNDN);
      mpfr_div_ui(square, square, 4, MPFR_RNDN);
      mpfr_set_ui(term, 1, MPFR_RNDN);
      for (int k = 1; k <= n; ++k) {
        mpfr_mul_d(term, term, x, MPFR_RNDN);
        mpfr_div_ui(term, term, static_cast<unsigned long>(2 * k), MPFR_RNDN);
      }
      mpfr_set(sum, term, MPFR_RNDN);
      for (int k = 1; k < 400; ++k) {
        mpfr_mul(term, term, square, MPFR_RNDN);
        mpfr_div_ui(term, term, static_cast<unsigned long>(k) * static_cast<unsigned long>(n + k), MPFR_RNDN);
        mpfr_add(sum, sum, term, MPFR_RNDN);
      }
      worst = std::max(worst, ulps(elementary::bessel_i(n, x), sum));
    }
  }
  EXPECT_LT(worst, 20);
  EXPECT_EQ(elementary::bessel_i(0, -1.5), elementary::bessel_i(0, 1.5));
  for (mpfr_ptr number : {mpfr_ptr(term), mpfr_ptr(square), mpfr_ptr(sum)}) mpfr_clear(number);
}

TEST(Elementary, Powers) {
  for (const double x : {0.3, 1.7, 12.5, 1e-3}) {
    for (const int n : {0, 1, 2, 7, -3, 40}) {
      EXPECT_NEAR(elementary::power(x, n), std::pow(x, n), 40 * 0x1p-52 * std::pow(x, n));
      EXPECT_EQ(elementary::power(x, static_cast<double>(n)), elementary::power(x, n));
    }
    for (const double y : {0.37, -2.2, 4.0 / 3, 17.9}) {
      EXPECT_NEAR(elementary::power(x, y), std::pow(x, y), 0x1p-51 * (1 + std::fabs(y * std::log(x))) * std::pow(x, y));
    }
  }
}

TEST(Elementary, BeyondTheRangeOfDouble) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(elementary::exp(1000), inf);
  EXPECT_EQ(elementary::exp(-1000), 0);
  EXPECT_EQ(elementary::exp(0), 1);
  EXPECT_EQ(elementary::log(0), -inf);
  EXPECT_EQ(elementary::log(inf), inf);
  EXPECT_EQ(elementary::log(1), 0);
  EXPECT_TRUE(std::isnan(elementary::log(-1)));
  EXPECT_TRUE(std::isnan(elementary::exp(std::numeric_limits<double>::quiet_NaN())));
  EXPECT_EQ(elementary::log(0x1p-1074), -1074 * 0.6931471805599453);
}

}  // namespace
}  // namespace lober::detail
