#include "kernels/sine.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "kernels/trigonometric.hpp"
#include "tests/oracle/random.hpp"

namespace lober::detail {
namespace {

double sine(double x) {
  double y = 0;
  add_sines(&y, &x, 1, 1);
  return y;
}

double ulp(double value) {
  return std::nextafter(std::fabs(value), INFINITY) - std::fabs(value);
}

double worst_error(double range, int count) {
  oracle::Random random(5);
  double worst = 0;
  for (int k = 0; k < count; ++k) {
    const double x = random.uniform(-range, range);
    const long double exact = std::sin(static_cast<long double>(x));
    const auto error = static_cast<double>(std::fabs(static_cast<long double>(sine(x)) - exact));
    worst = std::max(worst, error / ulp(static_cast<double>(exact)));
  }
  return worst;
}

TEST(Sine, IsRightToTwoAndAHalfUlps) {
  EXPECT_LT(worst_error(2, 200000), 2.5);
  EXPECT_LT(worst_error(100, 200000), 2.5);
  EXPECT_LT(worst_error(1e8, 200000), 2.5);
}

// The one of trigonometric.hpp, which flows use.
TEST(Cosine, IsRightToTwoAndAHalfUlps) {
  for (const double range : {2.0, 100.0, 1e5}) {
    oracle::Random random(6);
    double worst = 0;
    for (int k = 0; k < 200000; ++k) {
      const double x = random.uniform(-range, range);
      const long double exact = std::cos(static_cast<long double>(x));
      const auto error = static_cast<double>(std::fabs(static_cast<long double>(cosine(x)) - exact));
      worst = std::max(worst, error / ulp(static_cast<double>(exact)));
    }
    EXPECT_LT(worst, 2.5) << range;
    std::printf("cosine, |x| < %g: at most %.2f ulp\n", range, worst);
  }
}

TEST(Sine, KeepsItsDigitsNearMultiplesOfPi) {
  for (int k = -1000; k <= 1000; ++k) {
    const double x = std::numbers::pi * k;
    const long double exact = std::sin(static_cast<long double>(x));
    EXPECT_NEAR(sine(x), static_cast<double>(exact), 4e-28 * (1 + std::abs(k)) + 2 * ulp(static_cast<double>(exact)));
  }
  EXPECT_EQ(sine(0), 0);
  EXPECT_EQ(sine(1e-300), 1e-300);
}

TEST(Sine, DegradesWithTheAngleItself) {
  for (const double x : {3e9, 1.7e12, 123456789012345.6}) {
    const auto exact = static_cast<double>(std::sin(static_cast<long double>(x)));
    EXPECT_NEAR(sine(x), exact, 4 * ulp(x));
  }
}

TEST(Sine, SameBitsOneByOneAndTogether) {
  oracle::Random random(7);
  std::vector<double> x(1003), y(1003), together(1003);
  for (std::size_t k = 0; k < x.size(); ++k) {
    x[k] = random.uniform(-50, 50);
    y[k] = together[k] = random.uniform(-1, 1);
  }
  add_sines(together.data(), x.data(), 0.7, x.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    add_sines(&y[k], &x[k], 0.7, 1);
    EXPECT_EQ(y[k], together[k]);
  }
}

}  // namespace
}  // namespace lober::detail
