// Winding numbers and J against a count in rationals, on curves that cross and touch themselves.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "lober/overlay/interior.hpp"
#include "tests/oracle/exact_number.hpp"
#include "tests/oracle/random.hpp"

namespace lober::detail {
namespace {

using oracle::Random;
using oracle::Rational;
constexpr double full_turn = 2 * std::numbers::pi;

// By definition, in rationals and along another ray than the engine's: upwards.
Winding brute_force(const std::vector<Point>& curve, Point point) {
  int number = 0;
  for (std::size_t k = 0; k < curve.size(); ++k) {
    const Point a = curve[k], b = curve[k + 1 == curve.size() ? 0 : k + 1];
    const bool beside = std::min(a.x, b.x) > point.x || std::max(a.x, b.x) < point.x;
    if (beside) continue;
    const Rational ux = Rational(a.x) - Rational(point.x), uy = Rational(a.y) - Rational(point.y);
    const Rational vx = Rational(b.x) - Rational(point.x), vy = Rational(b.y) - Rational(point.y);
    const int side = sgn(Rational(ux * vy - uy * vx));
    if (side == 0 && sgn(Rational(ux * vx + uy * vy)) <= 0) return {0, true};
    const int rightward = static_cast<int>(b.x > point.x) - static_cast<int>(a.x > point.x);
    if (side == -rightward) number -= rightward;  // above the point
  }
  return {number, false};
}

void expect_right(const std::vector<Point>& curve, const std::vector<Point>& points, const std::string& what) {
  const IndexedCurve indexed{CurveView{curve}};
  for (const Point point : points) {
    const Winding expected = brute_force(curve, point), found = winding(indexed, point);
    const InteriorValue value = interior_function(indexed, point);
    ASSERT_EQ(found.on, expected.on) << what << " at " << point.x << ", " << point.y;
    ASSERT_EQ(found.number, expected.number) << what << " at " << point.x << ", " << point.y;
    ASSERT_EQ(value.on, expected.on) << what << " at " << point.x << ", " << point.y;
    if (expected.on) continue;
    ASSERT_NEAR(value.j / full_turn, expected.number, 1e-15 * static_cast<double>(curve.size() + 10))
        << what << " at " << point.x << ", " << point.y;
  }
}

// Points that ask for trouble: vertices, middles of segments, their neighbours, heights of vertices, anywhere.
std::vector<Point> awkward_points(Random& random, const std::vector<Point>& curve, int count) {
  std::vector<Point> points;
  const auto vertex = [&] { return curve[random.index(curve.size())]; };
  const auto nudged = [&](double x) { return std::nextafter(x, random.chance(0.5) ? 1e308 : -1e308); };
  for (int k = 0; k < count; ++k) {
    const std::size_t segment = random.index(curve.size());
    const Point a = curve[segment], b = curve[segment + 1 == curve.size() ? 0 : segment + 1];
    const Point middle{0.5 * a.x + 0.5 * b.x, 0.5 * a.y + 0.5 * b.y};
    points.insert(points.end(), {a,
                                 middle,
                                 {nudged(a.x), a.y},
                                 {middle.x, nudged(middle.y)},
                                 {vertex().x, vertex().y},
                                 {0.5 * vertex().x + 0.5 * vertex().x, vertex().y}});
  }
  return points;
}

std::vector<Point> lattice_walk(Random& random, int count, int size) {
  std::vector<Point> curve;
  for (int k = 0; k < count; ++k) {
    curve.push_back({static_cast<double>(random.integer(0, size)), static_cast<double>(random.integer(0, size))});
  }
  return curve;
}

std::vector<Point> scaled(std::vector<Point> curve, double x, double y) {
  for (Point& point : curve) point = {x * point.x, y * point.y};
  return curve;
}

TEST(WindingNumber, OfRandomCurvesOnALattice) {
  for (std::uint64_t seed = 0; seed < 300 && !HasFatalFailure(); ++seed) {
    Random random(seed);
    const int count = random.integer(3, 120), size = random.integer(1, 12);
    const std::vector<Point> curve = lattice_walk(random, count, size);  // crosses, touches and retraces itself
    std::vector<Point> points = awkward_points(random, curve, 3);
    for (int y = 0; y <= std::min(size, 6); ++y) {
      for (int x = 0; x <= std::min(size, 6); ++x) points.push_back({x + 0.0, y + 0.0});
    }
    expect_right(curve, points, "lattice " + std::to_string(seed));
  }
}

TEST(WindingNumber, OfRandomCurvesAtEveryScale) {
  for (std::uint64_t seed = 0; seed < 150 && !HasFatalFailure(); ++seed) {
    Random random(seed);
    const std::vector<Point> walk = lattice_walk(random, random.integer(3, 60), 9);
    const auto scale = [&] { return std::ldexp(random.uniform(1, 2), random.integer(-1040, 1018)); };
    const double both = scale();
    const std::vector<Point> curve = scaled(walk, both, seed % 2 == 0 ? both : scale());
    expect_right(curve, awkward_points(random, curve, 5), "scaled " + std::to_string(seed));
  }
  const double least = std::numeric_limits<double>::denorm_min(), most = std::numeric_limits<double>::max();
  const std::vector<Point> smallest{{0, 0}, {4 * least, 0}, {4 * least, 4 * least}, {0, 4 * least}};
  expect_right(smallest, {{least, least}, {0, least}, {5 * least, least}, {4 * least, 4 * least}}, "smallest");
  const std::vector<Point> largest{{-most, -most}, {most, -most}, {most, most}, {-most, most}};
  expect_right(largest, {{0, 0}, {most, 0}, {-most, -most}, {most, most}, {1, most}}, "largest");
}

TEST(WindingNumber, OfALongCurveThatWindsManyTimes) {
  constexpr int vertices = 4000, turns = 37;
  std::vector<Point> curve;
  for (int k = 0; k < vertices; ++k) {
    const double angle = full_turn * turns * k / vertices, radius = 1 + 0.5 * std::cos(angle * 7 / turns);
    curve.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  Random random(1);
  std::vector<Point> points = awkward_points(random, curve, 20);
  for (int k = 0; k < 200; ++k) points.push_back({random.uniform(-1.6, 1.6), random.uniform(-1.6, 1.6)});
  expect_right(curve, points, "turns");
  EXPECT_EQ(winding(IndexedCurve(CurveView{curve}), {0, 0}).number, turns);
  const std::vector<Point> backwards(curve.rbegin(), curve.rend());
  EXPECT_EQ(winding(IndexedCurve(CurveView{backwards}), {0, 0}).number, -turns);
}

TEST(InteriorFunction, IsTheSumOfArcTangents) {
  Random random(2);
  std::vector<Point> curve;
  for (int k = 0; k < 1000; ++k) curve.push_back({random.unit(), random.unit()});
  const IndexedCurve indexed{CurveView{curve}};
  for (int k = 0; k < 200; ++k) {
    const Point point{random.uniform(-0.1, 1.1), random.uniform(-0.1, 1.1)};
    EXPECT_NEAR(interior_function(indexed, point).j, interior_function_direct(CurveView{curve}, point), 1e-11);
  }
}

TEST(InteriorFunction, IsThePrincipalValueOnTheCurve) {
  const std::vector<Point> square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  const IndexedCurve indexed{CurveView{square}};
  const InteriorValue side = interior_function(indexed, {1, 0}), corner = interior_function(indexed, {2, 2});
  EXPECT_TRUE(side.on && corner.on);
  EXPECT_NEAR(side.j, full_turn / 2, 1e-15);
  EXPECT_NEAR(corner.j, full_turn / 4, 1e-15);
  EXPECT_NEAR(interior_function_direct(CurveView{square}, {1, 0}), full_turn / 2, 1e-15);
}

TEST(InteriorFunction, HasTheSignOfHalfATurnRight) {
  // Seen from a point an ulp beside a long segment its ends are opposite; on either side of it J differs by a turn.
  const std::vector<Point> sliver{{-1e8, 0}, {1e8, 1e-8}, {0, 1e8}};
  const IndexedCurve indexed{CurveView{sliver}};
  const double height = 0.5e-8;
  for (int ulps = -3; ulps <= 3; ++ulps) {
    const Point point{0, height + ulps * 0x1p-80};
    const Winding exact = brute_force(sliver, point);
    EXPECT_EQ(winding(indexed, point), exact) << ulps;
    const InteriorValue value = interior_function(indexed, point);
    EXPECT_EQ(value.on, exact.on) << ulps;
    if (!exact.on) {
      EXPECT_NEAR(value.j / full_turn, exact.number, 1e-15) << ulps;
    }
  }
}

TEST(InteriorFunction, BatchesAreTheSameForAnyNumberOfThreads) {
  Random random(3);
  std::vector<Point> curve, points;
  for (int k = 0; k < 3000; ++k) curve.push_back({random.unit(), random.unit()});
  for (int k = 0; k < 3000; ++k)
    points.push_back(k % 3 == 0 ? curve[static_cast<std::size_t>(k)] : Point{random.unit(), random.unit()});
  const IndexedCurve indexed{CurveView{curve}};
  const auto batch = [&](int threads) {
    return with_threads(threads,
                        [&] { return std::pair(windings(indexed, points), interior_function(indexed, points)); });
  };
  const auto [numbers, values] = batch(1);
  for (std::size_t k = 0; k < points.size(); k += 7) {
    EXPECT_EQ(numbers[k], winding(indexed, points[k]));
    EXPECT_EQ(values[k].j, interior_function(indexed, points[k]).j);
  }
  for (const int threads : {2, 4}) {
    const auto [other_numbers, other_values] = batch(threads);
    EXPECT_EQ(numbers, other_numbers);
    for (std::size_t k = 0; k < points.size(); ++k) {
      ASSERT_EQ(values[k].j, other_values[k].j);
      ASSERT_EQ(values[k].on, other_values[k].on);
    }
  }
}

}  // namespace
}  // namespace lober::detail
