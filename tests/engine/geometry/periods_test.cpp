// Curves that were stored modulo a period are followed across the seam.
#include "lober/curve/periods.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "lober/base/error.hpp"

namespace lober {
namespace {

std::vector<Point> spiral(std::size_t points, double turns, double step) {
  std::vector<Point> curve;
  for (std::size_t k = 0; k < points; ++k) {
    const double t = static_cast<double>(k) / static_cast<double>(points);
    curve.push_back({0.3 + turns * t, 0.5 + 0.1 * std::sin(step * t)});
  }
  return curve;
}

TEST(Periods, CurvesAreContinuousAgain) {
  for (const double period : {1.0, 2 * std::numbers::pi, 360.0, 1e-9}) {
    std::vector<Point> curve = spiral(1000, 7.5, 20);
    for (Point& point : curve) point.x *= period;
    std::vector<Point> stored = curve;
    for (Point& point : stored) point.x = std::fmod(point.x, period);
    EXPECT_EQ(unwrap(stored, {.x = period}), 7U);
    for (std::size_t k = 0; k < curve.size(); ++k) {
      EXPECT_NEAR(stored[k].x, curve[k].x, 1e-14 * period) << k;
      EXPECT_EQ(stored[k].y, curve[k].y);
    }
  }
}

TEST(Periods, BothCoordinates) {
  std::vector<Point> curve{{0.9, 0.1}, {0.1, 0.9}, {0.3, 0.7}};
  EXPECT_EQ(unwrap(curve, {.x = 1, .y = 1}), 2U);
  EXPECT_EQ(curve[1].x, 1.1);
  EXPECT_DOUBLE_EQ(curve[1].y, -0.1);
  EXPECT_EQ(curve[2].x, 1.3);
}

TEST(Periods, NothingHappensWithoutOne) {
  std::vector<Point> curve{{0, 0}, {100, 100}};
  EXPECT_EQ(unwrap(curve, {}), 0U);
  EXPECT_EQ(curve[1].x, 100);
  EXPECT_FALSE(Periods{}.any());
  for (const double period : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW((void)unwrap(curve, {.x = period}), UsageError);
    EXPECT_THROW((void)unwrap(curve, {.y = period}), UsageError);
  }
}

TEST(Periods, CurvesAreMovedNearEachOther) {
  std::vector<Point> curve{{10.1, 0}, {10.3, 0}}, others{{0, 0}, {0.2, 0}};
  move_near(curve, others, {.x = 1});
  EXPECT_NEAR(curve[0].x, 0.1, 1e-14);
  move_near(curve, others, {.x = 1});
  EXPECT_NEAR(curve[0].x, 0.1, 1e-14);
}

TEST(Periods, CurvesThatAreWiderTogetherAreWarnedOf) {
  Curve first, second;
  first.points = {{0, 0}, {0.7, 0}, {0.7, 0.7}};
  second.points = {{0.6, 0}, {1.2, 0}, {1.2, 1.2}};
  EXPECT_EQ(period_warning(first, second, {}), "");
  EXPECT_EQ(period_warning(first, second, {.x = 1.2, .y = 1.2}), "");
  EXPECT_EQ(period_warning(first, second, {.x = 1.1}),
            "the curves are together wider than the period of x: they could also meet where one of them is moved by a "
            "period, which is not counted");
  first.name = "one";
  second.name = "two";
  EXPECT_TRUE(period_warning(first, second, {.x = 2, .y = 1})
                  .starts_with("the curves one and two are together wider "
                               "than the period of y: "));
}

}  // namespace
}  // namespace lober
