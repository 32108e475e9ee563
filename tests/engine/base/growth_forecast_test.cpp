#include "engine/base/growth_forecast.hpp"

#include <gtest/gtest.h>

namespace lober::detail {
namespace {

TEST(GrowthForecast, GoesOnAsTheLastTwo) {
  GrowthForecast forecast;
  EXPECT_EQ(forecast.next(), 0);
  forecast.add(10);
  EXPECT_EQ(forecast.next(), 10);
  forecast.add(30);
  EXPECT_DOUBLE_EQ(forecast.next(), 90);
  EXPECT_DOUBLE_EQ(forecast.next(2), 270);
  EXPECT_DOUBLE_EQ(forecast.sum(2), 360);
  EXPECT_EQ(forecast.sum(0), 0);
  forecast.add(20);
  EXPECT_DOUBLE_EQ(forecast.next(5), 20) << "never fewer";
  EXPECT_EQ(forecast.count(), 3);
}

}  // namespace
}  // namespace lober::detail
