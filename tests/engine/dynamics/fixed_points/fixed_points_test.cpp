// Fixed points against reference values, and scans that find all of them.
#include "lober/dynamics/fixed_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/dynamics/dynamics.hpp"
#include "engine/dynamics/maps/plane.hpp"
#include "kernels/box.hpp"
#include "lober/base/error.hpp"
#include "tests/engine/dynamics/test_maps.hpp"
#include "tests/paths.hpp"

namespace lober::detail {
namespace {

struct FixedPointReference {
  const char* system;
  double gamma, x, lambda;
};

// 18 digits, from quadruple precision.
constexpr FixedPointReference references[] = {{"ovp", 0.5, 1.451260038107551142, 5.075684315001539492},
                                              {"ovp1", 0.5, 1.455237909563602025, 5.095707482544454574},
                                              {"ovp", 1.81, 1.566971704841645925, 389.431939040229329},
                                              {"ovp1", 1.81, 1.565153556496252236, 392.076048038816274}};

TEST(FixedPoints, OfTheVortexPair) {
  for (const FixedPointReference& reference : references) {
    SCOPED_TRACE(reference.system + std::string(" ") + std::to_string(reference.gamma));
    const System system = make_system(reference.system, {{"gamma", reference.gamma}, {"eps", 0.1}});
    // A scan of the window finds both, and nothing takes them for others.
    int found = 0;
    for (const FixedPoint& p : find_fixed_points(*system.map, system.window)) {
      if (p.kind != FixedPointKind::saddle || std::abs(p.at.y) > 1e-9) continue;
      ++found;
      const double side = p.at.x < 0 ? -1 : 1;
      EXPECT_NEAR(p.at.x, side * reference.x, 1e-12);
      EXPECT_NEAR(p.at.y, 0, 1e-12);
      EXPECT_NEAR(p.multipliers[0].real() / reference.lambda, 1, 1e-12);
      EXPECT_NEAR(p.multipliers[1].real() * reference.lambda, 1, 1e-12);
      // y = 0 is invariant: it is unstable on the left.
      EXPECT_NEAR(p.directions[side < 0 ? 0 : 1].x, 1, 1e-12);
      EXPECT_LT(p.residual, 1e-11);
    }
    EXPECT_EQ(found, 2);
  }
}

TEST(FixedPoints, OfTheThreeBodyProblem) {
  const System system = make_system("pcr3bp");
  const FixedPoint p = find_fixed_point(*system.map, {-2.03, 0.001});
  EXPECT_EQ(p.kind, FixedPointKind::saddle);
  EXPECT_NEAR(p.at.x, -2.02957956736457496, 2e-12);
  EXPECT_NEAR(p.at.y, 0, 1e-12);
  EXPECT_NEAR(p.multipliers[0].real() / 31.552237923806206, 1, 1e-12);
  EXPECT_NEAR(p.directions[0].y / p.directions[0].x, 0.28723120925948504, 1e-12);
  EXPECT_NEAR(p.directions[1].y / p.directions[1].x, -0.28723120925948504, 1e-12);
}

TEST(FixedPoints, OfMapsByFormula) {
  const double k = 1.2;
  const System standard = make_system("standard", {{"K", k}});
  const FixedPoint saddle = find_fixed_point(*standard.map, {0.2, 0.1});
  EXPECT_NEAR(saddle.at.x, 0, 1e-15);
  EXPECT_NEAR(saddle.at.y, 0, 1e-15);
  EXPECT_NEAR(saddle.multipliers[0].real(), 1 + k / 2 + std::sqrt(k + k * k / 4), 1e-14);
  const FixedPoint centre = find_fixed_point(*standard.map, {3, 0.1});
  EXPECT_EQ(centre.kind, FixedPointKind::centre);
  EXPECT_NEAR(std::abs(centre.multipliers[0]), 1, 1e-14);
  EXPECT_NEAR(2 * centre.multipliers[0].real(), 2 - k, 1e-14);
  // A rotation by 2 pi a step is fixed modulo the lattice.
  const FixedPoint rotation = find_fixed_point(*standard.map, {0.2, 6}, {.turns = 1, .lattice = standard.lattice});
  EXPECT_NEAR(rotation.at.y, 2 * std::numbers::pi, 1e-14);
  EXPECT_EQ(rotation.kind, FixedPointKind::saddle);

  const FixedPoint inverse = find_fixed_point(*make_system("standard", {{"K", 5}}).map, {3, 0.1});
  EXPECT_EQ(inverse.kind, FixedPointKind::inverse_saddle);
  EXPECT_NEAR(inverse.multipliers[0].real(), -1.5 - std::sqrt(1.25), 1e-13);
}

TEST(FixedPoints, ScanFindsAllOfTheHenonMap) {
  const System henon = make_system("henon", {{"k", 0.5}});
  const std::vector<FixedPoint> points = find_fixed_points(*henon.map, henon.window);
  ASSERT_EQ(points.size(), 2U);
  EXPECT_NEAR(points[0].at.x, 1 - std::sqrt(1.5), 1e-14);
  EXPECT_EQ(points[0].kind, FixedPointKind::centre);
  EXPECT_NEAR(points[1].at.x, 1 + std::sqrt(1.5), 1e-14);
  EXPECT_EQ(points[1].kind, FixedPointKind::saddle);
  // x + x' = c^2 - k twice over: for k > 3 two points of period 2 more, x = -1 +- sqrt(k - 3).
  const System wide = make_system("henon", {{"k", 4}});
  const std::vector<FixedPoint> two = find_fixed_points(*wide.map, wide.window, {.period = 2});
  ASSERT_EQ(two.size(), 4U);
  EXPECT_EQ(two[1].period, 1);
  EXPECT_EQ(two[2].period, 2);
  EXPECT_NEAR(two[2].at.x, -2, 1e-13);
  EXPECT_NEAR(two[3].at.x, 0, 1e-13);
}

TEST(FixedPoints, ScanFindsThePointsOfFlows) {
  const System duffing = make_system("duffing", {{"eps", 0.01}});
  const std::vector<FixedPoint> points =
      find_fixed_points(*duffing.map, Box::of({-1.2, -0.3}, {1.2, 0.3}), {.grid = 16});
  // The unperturbed equilibria (-1, 0), (0, 0), (1, 0) go on.
  int near_equilibria = 0;
  for (const FixedPoint& p : points) {
    near_equilibria += std::abs(p.at.x - std::round(p.at.x)) < 0.05 && std::abs(p.at.y) < 0.05 ? 1 : 0;
  }
  EXPECT_EQ(near_equilibria, 3);
}

// The saddle of a double well that is rocked once in 2 pi has a multiplier of about e^(2 pi): Newton's method for the
// whole period finds it from a thousandth of the well only, from where the grids here have no point.
TEST(FixedPoints, ScanFindsSaddlesOfLargeMultipliers) {
  for (const double eps : {0.02, 0.05, 0.1, 0.15, 0.2}) {
    const System duffing = make_system("duffing", {{"eps", eps}});
    for (const int grid : {32, 48}) {
      SCOPED_TRACE(std::to_string(eps) + " on a grid of " + std::to_string(grid));
      const std::vector<FixedPoint> points =
          find_fixed_points(*duffing.map, Box::of({-2, -1.7}, {2, 1.9}), {.grid = grid});
      EXPECT_EQ(points.size(), 9U);
      int strong = 0;
      for (const FixedPoint& p : points) {
        if (p.kind != FixedPointKind::saddle || std::abs(p.at.x + eps / 2) > 0.01) continue;
        ++strong;
        EXPECT_GT(p.multipliers[0].real(), 500);
        EXPECT_LT(p.residual, 1e-12);
      }
      EXPECT_EQ(strong, 1);
    }
  }
}

// A library that computes one velocity at a time takes ten times the work of a built-in system. The points are counted
// by another route: the force is even in time, so that points on y = 0 are those whose velocity is zero half a period
// later.
TEST(FixedPoints, TheDoubleWellOfALibraryHasAllItsPoints) {
  const System own = make_system(LOBER_TEST_LIBRARIES "/double_well.so");
  constexpr double half = 3.14159265358979323846;
  constexpr std::size_t count = 3601;
  std::vector<FlowState> states(count);
  for (std::size_t k = 0; k < count; ++k) states[k][0] = -1.8 + 0.001 * static_cast<double>(k);
  own.flow->integrate(states, 0, half, {});
  std::vector<double> expected;
  for (std::size_t k = 0; k + 1 < count; ++k) {
    const double a = states[k][1], b = states[k + 1][1];
    if (a * b < 0) expected.push_back(-1.8 + 0.001 * (static_cast<double>(k) + a / (a - b)));
  }
  ASSERT_EQ(expected.size(), 9U);
  for (const int grid : {12, 48}) {
    SCOPED_TRACE(grid);
    const FixedPointSearch found = search_fixed_points(*own.map, own.window, {.grid = grid});
    ASSERT_EQ(found.points.size(), expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) {
      EXPECT_NEAR(found.points[k].at.x, expected[k], 1e-5);
      EXPECT_NEAR(found.points[k].at.y, 0, 1e-11);
    }
    EXPECT_EQ(found.index_of_box, std::optional<int>(1));
    EXPECT_EQ(found.index_sum, 1);
  }
}

// Half a period on and another half make one; so do those back.
TEST(FixedPoints, HalvesOfAPeriodMakeAPeriod) {
  for (const char* const name : {"duffing", "ovp", "double-gyre"}) {
    SCOPED_TRACE(name);
    const System system = make_system(name), later = make_system(name, {{"phase", 0.5}});
    const auto half = system.map->half(), later_half = later.map->half();
    ASSERT_TRUE(half && later_half);
    const std::vector<Point> from{{0.31, 0.07}, {1.2, 0.05}};
    for (const int sign : {1, -1}) {
      std::vector<Point> at = from, at_once = from, three = from;
      half->iterate(at, sign);
      later_half->iterate(at, sign);
      system.map->iterate(at_once, sign);
      half->iterate(three, 3 * sign);
      for (std::size_t k = 0; k < at.size(); ++k) {
        EXPECT_NEAR(at[k].x, at_once[k].x, 1e-9);
        EXPECT_NEAR(at[k].y, at_once[k].y, 1e-9);
      }
      std::vector<Matrix2> product(from.size()), straight(from.size()), second(from.size());
      std::vector<Point> moved = from, whole = from;
      half->iterate_with_derivatives(moved, sign, product);
      later_half->iterate_with_derivatives(moved, sign, second);
      system.map->iterate_with_derivatives(whole, sign, straight);
      for (std::size_t k = 0; k < from.size(); ++k) {
        const Matrix2 both = second[k] * product[k];
        EXPECT_NEAR(both.xx, straight[k].xx, 1e-8 * (1 + std::abs(straight[k].xx)));
        EXPECT_NEAR(both.yx, straight[k].yx, 1e-8 * (1 + std::abs(straight[k].yx)));
      }
      half->iterate_with_derivatives(whole, sign, straight);
      for (std::size_t k = 0; k < from.size(); ++k) EXPECT_NEAR(whole[k].x, three[k].x, 1e-8);
    }
  }
  EXPECT_FALSE(make_system("henon").map->half());
}

TEST(FixedPoints, OfTheShipAreNotOnTheEdgeOfTheChart) {
  // Where vx = 0 the section is tangent to the flow; the map goes on there as a map of the edge, whose fixed points are
  // none.
  const System ship = make_system("capsize");
  for (const FixedPoint& p : find_fixed_points(*ship.map, ship.window)) {
    EXPECT_LT(p.residual, 1e-11);
    EXPECT_GT(ship.flow->on_section(*ship.section, 0.25307, p.at)[2], 1e-3);
  }
}

// The number of periodic points of the Henon map is known: 2^n of f^n for large k, where it is a horseshoe.
TEST(FixedPointSearch, FindsAllOfAHorseshoe) {
  const System system = make_system("henon", {{"k", 6}});
  for (const int period : {1, 2, 3, 4, 5}) {
    const FixedPointSearch search = search_fixed_points(*system.map, system.window, {.period = period});
    EXPECT_EQ(search.points.size(), std::size_t{1} << period) << period;
    EXPECT_TRUE(search.settled) << period;
    for (const FixedPoint& point : search.points) EXPECT_EQ(period % point.period, 0);
  }
}

// (0, pi) goes to (pi, pi) and that to (2 pi, pi): half a turn each, which is not a symmetry of the map.
TEST(FixedPoints, APeriodMakesWholeTurns) {
  const double k = 1.2, pi = std::numbers::pi;
  const System standard = make_system("standard", {{"K", k}});
  for (const int times : {1, 2, 3, -1}) {  // period 2 once, twice, ... over
    SCOPED_TRACE(times);
    const int turns = times < 0 ? -1 : times;
    const double y = times < 0 ? -pi : pi;
    const FixedPointOptions options{.period = 2 * std::abs(times), .turns = turns, .lattice = standard.lattice};
    const FixedPointSearch search = search_fixed_points(*standard.map, Box::of({-1, y - 0.1}, {5.5, y + 0.1}), options);
    EXPECT_TRUE(search.settled);
    ASSERT_EQ(search.points.size(), 2U);
    for (const FixedPoint& point : search.points) {
      EXPECT_EQ(point.period, 2);
      EXPECT_EQ(point.kind, FixedPointKind::centre);
      EXPECT_NEAR(point.at.y, y, 1e-14);
      EXPECT_NEAR(residue(point), k * k / 4, 1e-13);
    }
    const FixedPoint near = find_fixed_point(*standard.map, {0.1, y}, options);
    EXPECT_EQ(near.period, 2);
    EXPECT_NEAR(residue(near), k * k / 4, 1e-13);
  }
  EXPECT_THROW((void)search_fixed_points(*standard.map, standard.window, {.turns = 1}), UsageError);
}

// Two orbits of the resonance 5/12 at least (Poincare and Birkhoff), too thin for these grids.
TEST(FixedPointSearch, NothingFoundIsNotSettledWhereTheIndexIsNotKnown) {
  const System standard = make_system("standard", {{"K", 0.2}});
  const FixedPointSearch search =
      search_fixed_points(*standard.map, standard.window, {.period = 12, .turns = 5, .lattice = standard.lattice}, 96);
  EXPECT_TRUE(!search.settled || search.points.size() >= 24);
}

// Where a point of a smaller period is about to bifurcate, f^period(z) - z grows with the cube of the distance, and
// Newton's method ends some 1e-5 away from it, or nowhere.
TEST(FixedPointSearch, PointsAboutToBifurcateAreFoundOnce) {
  struct Case {
    const char* system;
    const char* parameter;
    double value;
    int period;
    Point at;  // of period 1
    std::size_t points;
  };
  for (const Case& c :
       {Case{"henon", "k", 3, 2, {-1, -1}, 2}, Case{"henon", "k", 3, 4, {-1, -1}, 10},
        Case{"henon", "k", 0, 4, {0, 0}, 2}, Case{"henon", "k", 3 + 1e-8, 2, {-1 - 2.5e-9, -1 - 2.5e-9}, 4},
        Case{"standard", "K", 4, 2, {std::numbers::pi, 0}, 2}}) {
    SCOPED_TRACE(std::string(c.system) + " " + std::to_string(c.value) + ", period " + std::to_string(c.period));
    const System system = make_system(c.system, {{c.parameter, c.value}});
    const FixedPointSearch search = search_fixed_points(*system.map, system.window, {.period = c.period});
    EXPECT_TRUE(search.settled);
    EXPECT_EQ(search.points.size(), c.points);
    int found = 0;
    for (const FixedPoint& point : search.points) {
      if (point.period != 1 || length(point.at - c.at) > 1e-12) continue;
      ++found;
      EXPECT_LT(point.residual, 2e-15);
    }
    EXPECT_EQ(found, 1);
    const FixedPoint near = find_fixed_point(*system.map, {c.at.x - 1e-6, c.at.y + 1e-6}, {.period = c.period});
    EXPECT_EQ(near.period, 1);
    EXPECT_LT(length(near.at - c.at), 1e-12);
  }
}

// The 2^9 points are seen half way on and half way back, where they are stretched by the square root of 20^9.
TEST(FixedPointSearch, FindsAllOfAHorseshoeOfALongPeriod) {
  const System system = make_system("henon", {{"k", 10}});
  const FixedPointSearch search = search_fixed_points(*system.map, system.window, {.period = 9});
  EXPECT_EQ(search.points.size(), 512U);
}

// In a resonance the displacement is a valley, hundreds of thousands of times as long as it is deep. Two orbits
// (Poincare and Birkhoff), one of saddles and one of points of the other index.
TEST(FixedPointSearch, ThinResonancesHaveAllTheirPoints) {
  struct Case {
    double k;
    int period, turns;
  };
  for (const Case& c : {Case{0.1, 8, 3}, Case{0.2, 12, 5}, Case{0.3, 13, 5}, Case{0.5, 8, 3}, Case{0.97, 21, 8}}) {
    SCOPED_TRACE(c.k);
    const System standard = make_system("standard", {{"K", c.k}});
    const FixedPointOptions options{.period = c.period, .turns = c.turns, .lattice = standard.lattice};
    const double left = -1.2, pi = std::numbers::pi;
    const FixedPointSearch search =
        search_fixed_points(*standard.map, Box::of({left, 1.8}, {left + 2 * pi, 3}), options);
    EXPECT_TRUE(search.settled);
    EXPECT_EQ(search.index_of_box, 0);
    int saddles = 0, others = 0;
    for (const FixedPoint& point : search.points) {
      EXPECT_EQ(point.period, c.period);
      ++(point.kind == FixedPointKind::saddle ? saddles : others);
    }
    EXPECT_EQ(saddles, c.period);
    EXPECT_EQ(others, c.period);
  }
}

// The images of a point are points too, whatever grids see; so are its copies.
TEST(FixedPointSearch, OrbitsAreWhole) {
  const double k = 4.954836841670506;
  const System standard = make_system("standard", {{"K", k}});
  const FixedPointOptions options{.period = 10, .turns = -4, .lattice = standard.lattice};
  const Rectangle box = Box::of({-5.554, -2.818}, {-1.420, -2.501});
  const FixedPointSearch search = search_fixed_points(*standard.map, box, options);
  EXPECT_GT(search.points.size(), 100U);
  const auto is_found = [&](Point z) {
    return std::any_of(search.points.begin(), search.points.end(),
                       [&](const FixedPoint& point) { return length(point.at - z) < 1e-6; });
  };
  EXPECT_TRUE(is_found({-2.66414967622619, -2.75433539188753}));
  for (const FixedPoint& point : search.points) {
    Point z = point.at;
    for (int n = 1; n < point.period; ++n) {
      standard.map->iterate({&z, 1}, 1);
      for (const int copies : {-3, -2, -1, 0, 1, 2, 3}) {
        const Point place{z.x + copies * standard.lattice.x, z.y};
        const bool well_inside = box.min_x + 1e-6 < place.x && place.x < box.max_x - 1e-6 &&
                                 box.min_y + 1e-6 < place.y && place.y < box.max_y - 1e-6;
        EXPECT_TRUE(!well_inside || is_found(place)) << point.at.x << " " << point.at.y << " " << n;
      }
    }
  }
}

// Where a saddle and a centre meet, or three saddles at a centre, rounding does not decide what is there.
TEST(FixedPointSearch, DegeneratePointsAreParabolic) {
  struct Case {
    const char* system;
    const char* parameter;
    double value;
    int period;
    Rectangle box;
    std::size_t points, degenerate;
  };
  const double pi = std::numbers::pi;
  for (const Case& c : {Case{"henon", "k", -1, 1, Box::of({-6, -6}, {6, 6}), 1, 1},
                        Case{"henon", "k", -1, 4, Box::of({-6, -6}, {6, 6}), 1, 1},
                        Case{"henon", "k", 1, 3, Box::of({-3.4, -3.4}, {3.4, 3.4}), 5, 3},
                        Case{"standard", "K", 2 * pi, 2, Box::of({-1.013, -6.61}, {5.57, 6.65}), 4, 2}}) {
    SCOPED_TRACE(std::string(c.system) + " " + std::to_string(c.value) + ", period " + std::to_string(c.period));
    const System system = make_system(c.system, {{c.parameter, c.value}});
    const FixedPointSearch search = search_fixed_points(*system.map, c.box, {.period = c.period});
    EXPECT_TRUE(search.settled);
    EXPECT_TRUE(search.isolated);
    EXPECT_EQ(search.points.size(), c.points);
    ASSERT_TRUE(search.index_of_box);  // those of degenerate points are counted round them
    EXPECT_EQ(*search.index_of_box, search.index_sum);
    std::size_t degenerate = 0;
    for (const FixedPoint& point : search.points) {
      if (index_of(point, c.period) != 0) continue;
      ++degenerate;
      EXPECT_EQ(point.kind, FixedPointKind::parabolic);
      EXPECT_EQ(point.multipliers[0], 1.0);
    }
    EXPECT_EQ(degenerate, c.degenerate);
  }
}

// Newton's method ends 1e-8 away where two points meet, 1e-6 where three do.
TEST(FixedPointSearch, DegeneratePointsAreWhereTheyAre) {
  struct Case {
    const char* system;
    const char* parameter;
    double value;
    int period;
    Point at;
    double error;
  };
  const double pi = std::numbers::pi, golden = std::numbers::phi;
  for (const Case& c :
       {Case{"henon", "k", -1, 1, {1, 1}, 1e-13}, Case{"henon", "k", -1, 4, {1, 1}, 1e-13},
        Case{"henon", "k", 1, 3, {-1, 0}, 1e-13}, Case{"henon", "k", 1, 3, {0, -1}, 1e-13},
        Case{"henon", "k", 3, 6, {-2, golden}, 2e-8}, Case{"henon", "k", 3, 6, {1 - golden, 1 - golden}, 2e-8},
        Case{"standard", "K", 2 * pi, 2, {pi / 2, -pi}, 2e-8}}) {
    SCOPED_TRACE(std::string(c.system) + " " + std::to_string(c.value) + ", period " + std::to_string(c.period));
    const System system = make_system(c.system, {{c.parameter, c.value}});
    const Rectangle box = Box::of({-3.4, -3.3}, {3.5, 3.6});
    const FixedPointSearch search = search_fixed_points(*system.map, box, {.period = c.period});
    EXPECT_TRUE(std::any_of(search.points.begin(), search.points.end(), [&](const FixedPoint& point) {
      return point.kind == FixedPointKind::parabolic && length(point.at - c.at) < c.error;
    }));
  }
}

// Newton's method comes near to a zero where the displacement is small but is not one: residuals were 1e-7.
TEST(FixedPointSearch, FloorsOfValleysAreNoPoints) {
  const System henon = make_system("henon", {{"k", 0.5}});
  const FixedPointSearch search = search_fixed_points(*henon.map, Box::of({-4.1, -4.03}, {4.07, 4.11}), {.period = 7});
  EXPECT_TRUE(search.settled);
  EXPECT_EQ(search.points.size(), 30U);  // 2 of period 1, four orbits of period 7
  for (const FixedPoint& point : search.points) EXPECT_LT(point.residual, 1e-12);
}

// Four of 10 points were missing and 6 called all of them: the others are nearer to these than rounding resolves.
TEST(FixedPointSearch, WhatRoundingHidesIsNotSettled) {
  const System close = make_system("henon", {{"k", 1e-12}});
  const FixedPointSearch hidden = search_fixed_points(*close.map, close.window, {.period = 4});
  EXPECT_TRUE(!hidden.settled || hidden.points.size() == 10);
  const System apart = make_system("henon", {{"k", 1e-6}});
  const FixedPointSearch seen = search_fixed_points(*apart.map, apart.window, {.period = 4});
  EXPECT_TRUE(seen.settled);
  EXPECT_EQ(seen.points.size(), 10U);
}

// Half way is an odd number of images back for periods 2, 3, 6, 7: indices there have the other sign.
TEST(FixedPointSearch, IndicesOfAMapThatReversesOrientation) {
  const test::DissipativeHenonMap map(1.4, 0.3);
  for (const int period : {1, 2, 3, 4, 5, 6, 7}) {
    SCOPED_TRACE(period);
    const FixedPointSearch search = search_fixed_points(map, Box::of({-2.03, -2.01}, {2.02, 2.04}), {.period = period});
    EXPECT_TRUE(search.settled);
    ASSERT_TRUE(search.index_of_box);
    EXPECT_EQ(*search.index_of_box, search.index_sum);
    // One point alone, whose index is not 0.
    const Point z = search.points.back().at;
    const FixedPointSearch one =
        search_fixed_points(map, Box::of({z.x - 1e-3, z.y - 1e-3}, {z.x + 1e-3, z.y + 1e-3}), {.period = period});
    ASSERT_EQ(one.points.size(), 1U);
    EXPECT_EQ(one.index_of_box, index_of(one.points[0], period));
  }
}

TEST(FixedPointSearch, ComparesWithTheIndexOfTheBox) {
  const System standard = make_system("standard", {{"K", 1.2}});
  const FixedPointSearch both = search_fixed_points(*standard.map, standard.window);
  EXPECT_EQ(both.index_of_box, 0);  // a saddle and a centre
  EXPECT_TRUE(both.settled);
  const FixedPointSearch centre = search_fixed_points(*standard.map, Box::of({2, -1}, {4, 1}));
  EXPECT_EQ(centre.index_of_box, 1);
  ASSERT_EQ(centre.points.size(), 1U);
  EXPECT_EQ(index_of(centre.points[0], 1), 1);
  EXPECT_NEAR(residue(centre.points[0]), 0.3, 1e-12);  // K / 4
  const FixedPointSearch saddle = search_fixed_points(*standard.map, Box::of({-1, -1}, {1, 1}));
  EXPECT_EQ(saddle.index_of_box, -1);
  EXPECT_NEAR(residue(saddle.points[0]), -0.3, 1e-12);
  const FixedPointSearch none = search_fixed_points(*standard.map, Box::of({1, 1}, {2, 2}));
  EXPECT_EQ(none.index_of_box, 0);
  EXPECT_TRUE(none.points.empty());
  // A point on the edge: nothing can be said.
  EXPECT_FALSE(search_fixed_points(*standard.map, Box::of({0, -1}, {1, 1})).index_of_box);
  // A grid that sees nothing at first is made finer until the indices agree.
  const System henon = make_system("henon", {{"k", 6}});
  const FixedPointSearch fine = search_fixed_points(*henon.map, henon.window, {.period = 5, .grid = 3}, 768);
  EXPECT_GT(fine.grid, 3);
  EXPECT_EQ(fine.points.size(), 32U);
  EXPECT_THROW((void)search_fixed_points(*henon.map, henon.window, {.grid = 10}, 5), UsageError);
  EXPECT_THROW((void)search_fixed_points(*henon.map, henon.window, {}, 96, [](const std::string&) { return false; }),
               Cancelled);
}

TEST(FixedPoints, NoneIsSaidClearly) {
  const System system = make_system("henon");
  try {
    static_cast<void>(find_fixed_points(*system.map, Box::of({5, 5}, {6, 6})));
    FAIL();
  } catch (const DataError& error) {
    EXPECT_NE(std::string(error.what()).find("no point of period 1 in [5, 6] x [5, 6]"), std::string::npos)
        << error.what();
  }
  EXPECT_THROW(static_cast<void>(find_fixed_point(*make_system("capsize").map, {2, 0})), DataError);
  // k < -1: no fixed points at all.
  EXPECT_THROW(static_cast<void>(find_fixed_point(*make_system("henon", {{"k", -1.5}}).map, {1, 1})), DataError);
  EXPECT_THROW(static_cast<void>(find_fixed_point(*system.map, {1, 1}, {.period = 0})), UsageError);
}

}  // namespace
}  // namespace lober::detail
