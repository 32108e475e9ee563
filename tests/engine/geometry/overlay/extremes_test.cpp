// Curves at the ends of the range of double.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "engine/geometry/curve/countable.hpp"
#include "engine/geometry/index/index.hpp"
#include "lober/overlay/interior.hpp"
#include "lober/overlay/overlay.hpp"
#include "lober/overlay/regions.hpp"
#include "lober/overlay/smooth.hpp"
#include "lober/tangle/tangle.hpp"
#include "tests/refusal.hpp"
#include "tests/shapes.hpp"
#include "tests/views.hpp"

namespace lober::test {
using namespace lober::detail;
namespace {

TEST(Extremes, AnAreaBeyondTheLargestDoubleIsAnError) {
  const Points first = box(-1e155, -1e155, 1e155, 1e155), second = box(0, 0, 2e155, 1e155);
  const CurveView c1{first}, c2{second};
  const std::string reason = "larger than the largest double";
  EXPECT_NE(refusal([&] { (void)overlay(c1, c2); }).find(reason), std::string::npos);
  EXPECT_NE(refusal([&] { (void)interior_areas(c1, c2); }).find(reason), std::string::npos);
  EXPECT_NE(refusal([&] { (void)regions(c1, c2); }).find(reason), std::string::npos);
  EXPECT_NE(refusal([&] { (void)regions(c1); }).find(reason), std::string::npos);
  EXPECT_NE(refusal([&] { (void)signed_area(c1); }).find(reason), std::string::npos);
  EXPECT_NE(refusal([&] { (void)smooth_area(c1); }).find(reason), std::string::npos);
  const Points u{{0, 0}, {1e155, 1e155}, {2e155, -1e155}, {3e155, 1e155}}, s{{9e155, 0}, {-1e155, 0}};
  EXPECT_NE(refusal([&] { (void)tangle(CurveView{u, false}, CurveView{s, false}); }).find(reason), std::string::npos);
}

// C2 has an area of 1e420, which sums about a point of C1 lose.
TEST(Extremes, AnAreaThatIsLostBesideAMuchLargerCurveIsAnErrorAndNotZero) {
  const Points needle{{1e300, 0}, {1e300, 1e-3}, {0, 0}}, spike{{1e300, 0}, {0, 0}, {-1e299, 0}};
  for (const double side : {1e150, 1e210}) {
    const Points square = box(0, 0, side, side), bow_tie{{0, 0}, {side, side}, {side, 0}, {0, side}};
    const std::string reason = "larger than the largest double";
    EXPECT_NE(refusal([&] { (void)interior_areas(CurveView{needle}, CurveView{square}); }).find(reason),
              std::string::npos);
    for (const Points& large : {needle, spike}) {
      for (const Points& lost : {square, bow_tie}) {
        EXPECT_NE(refusal([&] { (void)regions(CurveView{large}, CurveView{lost}); }).find(reason), std::string::npos);
      }
    }
  }
}

TEST(Extremes, AnAreaJustBelowItIsNot) {
  const Points first = box(-5e153, -5e153, 5e153, 5e153), second = box(0, 0, 9e153, 5e153);
  const Overlay result = overlay(CurveView{first}, CurveView{second});
  EXPECT_NEAR(result.areas.union_ / 1.2e308, 1, 1e-15);
  EXPECT_EQ(result.areas.c1, signed_area(CurveView{first}));
  EXPECT_NEAR(regions(CurveView{first}, CurveView{second}).areas(FillRule::nonzero).union_ / 1.2e308, 1, 1e-15);
  EXPECT_TRUE(std::isfinite(discretisation_error(result).union_));
}

// Squares of the lengths of segments underflow long before areas do. Numbers below 2^-1022 keep fewer digits.
TEST(Extremes, TheEstimateOfTheDiscretisationIsTheSameAtAnyScale) {
  const auto circle = [](double x, double radius, int points, int exponent) {
    Points result;
    for (int k = 0; k < points; ++k) {
      const double angle = 2 * std::numbers::pi * (k + 0.3) / points;
      result.push_back(
          {std::ldexp(x + radius * std::cos(angle), exponent), std::ldexp(radius * std::sin(angle), exponent)});
    }
    return result;
  };
  for (const double distance :
       {0.7, 2 - 1e-4, 0.2}) {  // two crossings, a lens that polygons miss, a circle in the other
    for (const int points : {90, 5000}) {
      const auto estimate = [&](int exponent) {
        const Points c1 = circle(0, 1, points, exponent), c2 = circle(distance, distance < 0.5 ? 0.5 : 1, 70, exponent);
        return discretisation_error(overlay(CurveView{c1}, CurveView{c2}));
      };
      const Areas plain = estimate(0);
      for (const int exponent : {-511, -505, -490, -300, 450}) {
        const Areas scaled = estimate(exponent);
        for (const auto member : {&Areas::c1, &Areas::c2, &Areas::intersection, &Areas::union_, &Areas::c1_minus_c2,
                                  &Areas::c2_minus_c1, &Areas::symmetric_difference}) {
          const double one = std::ldexp(1, 2 * exponent);
          EXPECT_NEAR(scaled.*member, plain.*member * one, 1e-10 * plain.*member * one + 1e-14 * one)
              << distance << ' ' << points << ' ' << exponent;
        }
      }
    }
  }
}

TEST(Extremes, CrossingsOfSegmentsLongerThanTheLargestDoubleHaveAPlace) {
  const Points first = box(-1.5e308, -0.25, 1.5e308, 0.25), second = box(-1e307, -0.5, 2e307, 0.5);
  const Overlay result = overlay(CurveView{first}, CurveView{second});
  ASSERT_EQ(result.nodes.crossings(), 4U);
  for (std::size_t k = 0; k < 4; ++k) {
    const Point at = result.nodes[k].begin;
    EXPECT_NEAR(std::min(std::fabs(at.x / 1e307 + 1), std::fabs(at.x / 1e307 - 2)), 0, 1e-13) << k;
    EXPECT_EQ(std::fabs(at.y), 0.25) << k;
  }
  for (const Pairing pairing : all_pairings) {
    for (const Point centroid : centroids(result, pairing)) {
      EXPECT_TRUE(std::isfinite(centroid.x) && std::isfinite(centroid.y)) << name(pairing);
    }
  }
  const Regions found = regions(CurveView{first}, CurveView{second});
  for (const Points& polygon : found.pieces(FillRule::nonzero, Pairing::intersection).outline(0)) {
    for (const Point p : polygon) EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y));
  }
}

TEST(Extremes, TheRefusalOfACurveNamesThePlaceAsTheCallerKnowsIt) {
  const double scale = 0x1p600;
  Points loop{{0, 0}, {4, 4}, {4, 0}, {0, 4}}, other = box(0, 0, 1, 1);
  for (Points* points : {&loop, &other}) {
    for (Point& p : *points) p = {scale * p.x, scale * p.y};
  }
  const auto point_in_message = [](const auto& call) {
    try {
      call();
    } catch (const NotSimpleError& error) {
      return error.at;
    }
    return Point{};
  };
  const Point expected{2 * scale, 2 * scale};
  EXPECT_EQ(point_in_message([&] { (void)overlay(CurveView{loop}, CurveView{other}); }), expected);
  EXPECT_EQ(point_in_message([&] { (void)interior_areas(CurveView{loop}, CurveView{other}); }), expected);
  EXPECT_EQ(point_in_message([&] { (void)tangle(CurveView{loop, false}, CurveView{other, false}); }), expected);
}

// Nothing of the curves is read: there is only one point.
TEST(Extremes, MoreSegmentsThanCanBeNumberedAreRefused) {
  const Point point;
  const CurveView huge{{&point, std::size_t{1} << 31}};
  EXPECT_NE(refusal([&] { (void)IndexedCurve(huge); }).find("the limit is 2147483647"), std::string::npos);
  EXPECT_NE(refusal([&] { (void)overlay(huge, huge); }).find("the limit is 2147483647"), std::string::npos);
  EXPECT_NO_THROW(require_countable(max_count, "contacts"));
  EXPECT_EQ(refusal([&] { require_countable(max_count + 1, "contacts"); }),
            "2147483648 contacts, the limit is 2147483647");
}

}  // namespace
}  // namespace lober::test
