// The integral of two winding numbers, where both are known.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "lober/overlay/smooth.hpp"

namespace lober {
namespace {

constexpr double pi = std::numbers::pi;

// r = 1 + 2 cos t: winds once round an area of pi + 3 sqrt 3, and twice round pi - 1.5 sqrt 3 within it.
ClosedCurve limacon(std::size_t points, double phase = 0, double x = 0) {
  std::vector<Point> curve;
  for (std::size_t k = 0; k < points; ++k) {
    const double t = 2 * pi * (static_cast<double>(k) + phase) / static_cast<double>(points);
    const double r = 1 + 2 * std::cos(t);
    curve.push_back({x + r * std::cos(t), r * std::sin(t)});
  }
  return ClosedCurve(std::move(curve));
}
ClosedCurve circle(std::size_t points, double x, double radius, bool clockwise = false) {
  std::vector<Point> curve;
  for (std::size_t k = 0; k < points; ++k) {
    const double t = (clockwise ? -2 : 2) * pi * static_cast<double>(k) / static_cast<double>(points);
    curve.push_back({x + radius * std::cos(t), radius * std::sin(t)});
  }
  return ClosedCurve(std::move(curve));
}

// Polygons of 1000 points are off by 1e-5; each part counts as often as both wind round it.
TEST(WindingProduct, OfACurveThatWindsTwice) {
  for (const std::size_t points : {1000U, 1001U}) {
    const CommonArea inside = winding_product(limacon(points), circle(points, 1, 9));
    EXPECT_NEAR(inside.area, 3 * pi, 1e-9);
    EXPECT_NEAR(winding_product(limacon(points), circle(points, 1, 9, true)).area, -3 * pi, 1e-9);
    const CommonArea itself = winding_product(limacon(points), limacon(points));
    EXPECT_NEAR(itself.area, 5 * pi - 3 * std::sqrt(3), 1e-6);  // four segments cross others
    EXPECT_NEAR(itself.area, 5 * pi - 3 * std::sqrt(3), itself.error);
    const CommonArea other_points = winding_product(limacon(points), limacon(points, 0.3));
    EXPECT_NEAR(other_points.area, 5 * pi - 3 * std::sqrt(3), other_points.error);
    EXPECT_LT(other_points.error, 1e-3);  // two polygons of one curve cross each other everywhere
  }
}

TEST(WindingProduct, OfCurvesThatCross) {
  const double exact = winding_product(limacon(64'000), circle(64'000, 2, 1)).area;
  double last = 1;
  for (const std::size_t points : {500U, 1000U, 2000U, 4000U}) {
    const CommonArea found = winding_product(limacon(points), circle(points, 2, 1));
    const double error = std::fabs(found.area - exact);
    EXPECT_LE(error, found.error) << points;
    EXPECT_LT(error, 1e-6 * std::pow(500.0 / static_cast<double>(points), 3)) << points;
    EXPECT_LT(found.error, last) << points;
    last = found.error;
  }
}

// An arc that leads out of the box that both share is cut there, whatever its direction: arcs must not be fitted across
// the cut.
TEST(WindingProduct, BarsCoverWhereACurveLeavesTheBoxOfTheOther) {
  int cases = 0;
  double largest = 0;
  for (const double turn : {0.1, 0.4, 0.785, 1.1, 1.5, 2.2, 3.0}) {
    const auto turned = [&](std::size_t points) {
      std::vector<Point> curve;
      const ClosedCurve straight = limacon(points);
      for (const Point p : straight.points()) {
        curve.push_back({p.x * std::cos(turn) - p.y * std::sin(turn), p.x * std::sin(turn) + p.y * std::cos(turn)});
      }
      return ClosedCurve(std::move(curve));
    };
    for (const double x : {-2.5, -1.7, -0.9, 0.6, 1.3, 2.6}) {
      const double exact = winding_product(turned(32'000), circle(32'000, x, 0.8)).area;
      for (const std::size_t points : {60U, 90U, 150U}) {
        const CommonArea found = winding_product(turned(points), circle(40, x, 0.8));
        EXPECT_LE(std::fabs(found.area - exact), found.error) << turn << ' ' << x << ' ' << points;
        largest = std::max(largest, std::fabs(found.area - exact));
        ++cases;
      }
    }
  }
  EXPECT_EQ(cases, 126);
  EXPECT_LT(largest, 1e-3);
}

TEST(WindingProduct, OfCurvesThatShareNothing) {
  EXPECT_EQ(winding_product(limacon(100), circle(100, 50, 1)).area, 0);
  EXPECT_EQ(winding_product(circle(100, 0, 1), circle(100, 50, 1)).area, 0);
  EXPECT_EQ(winding_product(circle(100, 0, 1), circle(100, 50, 1)).error, 0);
}

}  // namespace
}  // namespace lober
