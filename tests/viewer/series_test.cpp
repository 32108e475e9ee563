#include "viewer/series.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace lober::viewer {
namespace {

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](double x, double y) {
           return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
         });
}

void expect_exact(const std::vector<double>& values) {
  EXPECT_TRUE(same_bits(decode_series(encode_series(values), values.size()), values));
}

TEST(Series, KeepsEveryBit) {
  constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  expect_exact({});
  expect_exact({0.1});
  expect_exact({-0.0, 0.0, -0.0, 1, -1});
  expect_exact({most, -most, least, -least, 0, 1});
  expect_exact({std::nan(""), HUGE_VAL, -HUGE_VAL, 1});
  std::vector<double> smooth, whole;
  for (int k = 0; k < 5000; ++k) {
    smooth.push_back(std::sin(1e-3 * k));
    whole.push_back(1e15 + k);
  }
  expect_exact(smooth);
  expect_exact(whole);
}

TEST(Series, KeepsEveryBitOfAnyDoubles) {
  std::mt19937_64 random(7);
  for (int round = 0; round < 200; ++round) {
    std::vector<double> values(random() % 1500);
    const int spread = static_cast<int>(random() % 2000);
    for (double& value : values) {
      const double fraction = static_cast<double>(static_cast<std::int64_t>(random())) * 0x1p-63;
      value = spread > 1900 ? std::bit_cast<double>(random())
                            : std::ldexp(fraction, static_cast<int>(random() % (1 + spread / 8)) - spread / 2);
    }
    expect_exact(values);
  }
}

TEST(Series, RoundsToHalfAStepButNotWhereItMustNot) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<double> values(3000);
  for (double& value : values) value = uniform(random);
  const double step = 0x1p-40;
  const std::vector<std::uint32_t> exact{700, 2999};
  const std::vector<double> found = decode_series(encode_series(values, step, exact), values.size());
  std::size_t rounded = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    EXPECT_LE(std::fabs(found[k] - values[k]), 0.5 * step);
    const std::size_t block = k / series_block;
    if (block == 700 / series_block || block == 2999 / series_block) {
      EXPECT_EQ(found[k], values[k]);
    }
    rounded += found[k] != values[k] ? 1 : 0;
  }
  EXPECT_GT(rounded, 1000U);
  EXPECT_LT(encode_series(values, step).size(), encode_series(values).size());
}

TEST(Series, SmoothCurvesTakeFewBytes) {
  std::vector<double> values;
  for (int k = 0; k < 100'000; ++k) values.push_back(std::cos(1e-5 * k));
  EXPECT_LT(encode_series(values, 0x1p-50).size(), values.size() * 3 / 2);
}

TEST(Series, BytesThatAreCutOffAreRefused) {
  const std::string bytes = encode_series(std::vector<double>(1000, 0.1));
  EXPECT_THROW((void)decode_series(std::string_view(bytes).substr(0, bytes.size() - 1), 1000), std::out_of_range);
}

}  // namespace
}  // namespace lober::viewer
