// Level curves of functions and of the energy of flows.
#include "lober/dynamics/levels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "lober/base/error.hpp"
#include "lober/base/threads.hpp"
#include "lober/curve/curve.hpp"
#include "lober/dynamics/systems.hpp"
#include "lober/overlay/areas.hpp"

namespace lober {
namespace {

const Rectangle square_window = Rectangle::of({-2, -2}, {2, 2});

double area_inside(const LevelCurve& curve) {
  double sum = 0;
  for (std::size_t k = 0; k < curve.points.size(); ++k) {
    const Point a = curve.points[k], b = curve.points[(k + 1) % curve.points.size()];
    sum += 0.5 * (a.x * b.y - a.y * b.x);
  }
  return sum;
}

TEST(LevelGrid, FollowsACircle) {
  const LevelGrid grid([](Point p) { return p.x * p.x + p.y * p.y; }, square_window, 200, 160);
  const auto curves = grid.curves(1);
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_TRUE(curves[0].closed);
  for (const Point& p : curves[0].points) EXPECT_NEAR(std::hypot(p.x, p.y), 1, 1e-15);
  // Larger values lie outside, on the left: clockwise.
  EXPECT_NEAR(area_inside(curves[0]), -std::numbers::pi, 1e-3);
  EXPECT_TRUE(grid.curves(-1).empty());
  EXPECT_TRUE(grid.curves(9).empty());
}

TEST(LevelGrid, EndsCurvesAtTheBorder) {
  const LevelGrid grid([](Point p) { return p.y - 0.3 * p.x; }, square_window, 37, 41);
  const auto curves = grid.curves(0.1);
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_FALSE(curves[0].closed);
  EXPECT_EQ(std::fabs(curves[0].points.front().x), 2);
  EXPECT_EQ(std::fabs(curves[0].points.back().x), 2);
  // Above the line the function is larger: it is on the left of a curve that runs to the right.
  EXPECT_LT(curves[0].points.front().x, curves[0].points.back().x);
}

// Two curves pass the cell of a saddle; the mean of its corners says which ones.
TEST(LevelGrid, PartsTheCellOfASaddle) {
  const auto saddle = [](Point p) { return p.x * p.y; };
  for (const double level : {-0.01, 0.01}) {
    const LevelGrid grid(saddle, square_window, 1, 1);
    const auto curves = grid.curves(level);
    ASSERT_EQ(curves.size(), 2U);
    for (const LevelCurve& curve : curves) {
      ASSERT_EQ(curve.points.size(), 2U);
      // A hyperbola has both of its ends in one quadrant.
      EXPECT_GT(curve.points[0].x * curve.points[1].x + curve.points[0].y * curve.points[1].y, -1);
      for (const Point& p : curve.points) EXPECT_NEAR(p.x * p.y, level, 1e-15);
    }
  }
  // Nodes on the level belong above it: no point twice, and all curves are there.
  const LevelGrid through(saddle, square_window, 4, 4);
  EXPECT_FALSE(through.curves(0).empty());
}

TEST(LevelGrid, LeavesOutCellsWithoutValue) {
  const auto half = [](Point p) { return p.x < 0 ? std::numeric_limits<double>::quiet_NaN() : p.y; };
  const LevelGrid grid(half, square_window, 40, 40);
  const auto curves = grid.curves(0.05);
  ASSERT_EQ(curves.size(), 1U);
  for (const Point& p : curves[0].points) EXPECT_GE(p.x, 0);
}

TEST(LevelGrid, HasTheSameCurvesForAnyThreads) {
  const auto wavy = [](Point p) { return std::sin(3 * p.x) * std::cos(2 * p.y) + 0.1 * p.x * p.y; };
  std::vector<std::vector<Point>> seen;
  for (const int threads : {1, 2, 7}) {
    run_with_threads(threads, [&] {
      std::vector<Point> all;
      for (const LevelCurve& curve : LevelGrid(wavy, square_window, 130, 90).curves(0.2)) {
        all.insert(all.end(), curve.points.begin(), curve.points.end());
      }
      seen.push_back(all);
    });
  }
  EXPECT_EQ(seen[0], seen[1]);
  EXPECT_EQ(seen[0], seen[2]);
}

TEST(LevelGrid, RefusesGridsWithoutCells) {
  const auto zero = [](Point) { return 0.0; };
  EXPECT_THROW(LevelGrid(zero, square_window, 0, 3), UsageError);
  EXPECT_THROW(LevelGrid(zero, Rectangle::of({0, 0}, {0, 1}), 3, 3), UsageError);
  EXPECT_THROW(LevelGrid(zero, square_window, 40'000, 3), UsageError);
}

// V = x^2/2 + y^2 - x^2 y; the saddles are at (+-1, 1/2) with 1/4.
TEST(EnergyOf, IsThePotentialOfTheShip) {
  const System ship = make_system("capsize");
  const PlaneFunction potential = energy_of(*ship.flow, 0);
  for (const Point p : {Point{0.3, 0.2}, Point{-1.5, 1.1}, Point{1, 0.5}}) {
    EXPECT_NEAR(potential(p), 0.5 * p.x * p.x + p.y * p.y - p.x * p.x * p.y, 1e-14);
  }
  const Equilibrium saddle = equilibrium_near(*ship.flow, {0.9, 0.6}, 0);
  EXPECT_NEAR(saddle.at.x, 1, 1e-12);
  EXPECT_NEAR(saddle.at.y, 0.5, 1e-12);
  EXPECT_NEAR(saddle.energy, 0.25, 1e-14);
  EXPECT_TRUE(saddle.saddle);
  EXPECT_FALSE(equilibrium_near(*ship.flow, {0.1, 0.05}, 0).saddle);
}

// The effective potential -(x^2 + y^2)/2 - (1 - mu)/r1 - mu/r2 - mu (1 - mu)/2: momenta are not velocities there.
TEST(EnergyOf, IsTheEffectivePotentialOfThreeBodies) {
  const double mu = 9.537e-4;
  const System bodies = make_system("pcr3bp", {{"mu", mu}});
  const PlaneFunction potential = energy_of(*bodies.flow, 0);
  for (const Point p : {Point{0.3, 0.2}, Point{-1.5, 1.1}}) {
    const double first = std::hypot(p.x + mu, p.y), second = std::hypot(p.x - 1 + mu, p.y);
    const double expected = -0.5 * (p.x * p.x + p.y * p.y) - (1 - mu) / first - mu / second - 0.5 * mu * (1 - mu);
    EXPECT_NEAR(potential(p), expected, 1e-13);
  }
}

TEST(EnergyOf, IsTheStreamFunctionOfThatMoment) {
  const System pair = make_system("ovp", {{"eps", 0}});
  const Equilibrium saddle = equilibrium_near(*pair.flow, {1.5, 0.1}, 0);
  EXPECT_NEAR(saddle.at.x, std::sqrt(3), 1e-12);
  EXPECT_NEAR(saddle.energy, 0, 1e-14);
  EXPECT_TRUE(saddle.saddle);
  const System forced = make_system("duffing", {{"eps", 0.3}, {"omega", 1}});
  EXPECT_NEAR(energy_of(*forced.flow, 0)({1, 0}), -0.25 - 0.3, 1e-15);
  EXPECT_NEAR(energy_of(*forced.flow, std::numbers::pi)({1, 0}), -0.25 + 0.3, 1e-15);
  const System damped = make_system("duffing", {{"delta", 0.1}});
  EXPECT_THROW((void)energy_of(*damped.flow, 0), UsageError);
  EXPECT_THROW((void)equilibrium_near(*pair.flow, {1e3, 1e3}, 0), DataError);
}

}  // namespace
}  // namespace lober
