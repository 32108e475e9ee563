// Centroids, slivers, discretisation and progress of an overlay.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "lober/overlay/overlay.hpp"
#include "tests/oracle/random.hpp"
#include "tests/views.hpp"

namespace lober::test {
using namespace lober::detail;
namespace {

std::vector<Point> ellipse(std::size_t points, double cx, double cy, double a, double b) {
  std::vector<Point> curve(points);
  for (std::size_t k = 0; k < points; ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(points);
    curve[k] = {cx + a * std::cos(angle), cy + b * std::sin(angle)};
  }
  return curve;
}

// Two unit circles at distance d: the area of the lens.
double lens_area(double d) {
  return 2 * std::acos(d / 2) - d / 2 * std::sqrt(4 - d * d);
}

TEST(Discretisation, IsRightToLeadingOrderOnSmoothCurves) {
  const double d = std::hypot(1, 0.3), lens = lens_area(d);
  for (const std::size_t points : {100U, 1000U, 10000U}) {
    const std::vector<Point> first = ellipse(points, 0, 0, 1, 1), second = ellipse(points, 1, 0.3, 1, 1);
    const Overlay result = overlay(CurveView{first}, CurveView{second});
    const Areas estimate = discretisation_error(result);
    EXPECT_NEAR(estimate.c1 / (std::numbers::pi - result.areas.c1), 1, 10.0 / static_cast<double>(points));
    EXPECT_NEAR(estimate.intersection / (lens - result.areas.intersection), 1, 10.0 / static_cast<double>(points));
    const double difference = std::numbers::pi - lens;  // here the losses of the two curves cancel
    EXPECT_LE(std::fabs(difference - result.areas.c1_minus_c2),
              1.5 * estimate.c1_minus_c2 + estimate.c1 * 20.0 / static_cast<double>(points));
  }
}

// In extended precision, as lenses are thin: two circles of radii r and s at distance d.
double thin_lens_area(double r, double s, double d) {
  const auto segment = [](long double radius, long double height) {
    return radius * radius * std::acos(height / radius) - height * std::sqrt((radius - height) * (radius + height));
  };
  const long double along = (static_cast<long double>(d) * d + static_cast<long double>(r) * r - s * s) / (2 * d);
  return static_cast<double>(segment(r, along) + segment(s, d - along));
}

// The lens is thinner than the arcs over the segments are high: what it gains at its ends is nine tenths of it.
TEST(Discretisation, KnowsThatTheEndsOfThinLensesMove) {
  const double d = 1.99999;
  const std::vector<Point> first = ellipse(500, 0, 0, 1, 1), second = ellipse(200, d, 0, 1, 1);
  const double lens = thin_lens_area(1, 1, d);
  for (const bool swapped : {false, true}) {
    const Overlay result =
        swapped ? overlay(CurveView{second}, CurveView{first}) : overlay(CurveView{first}, CurveView{second});
    const double lost = lens - result.areas.intersection;
    EXPECT_GT(lost, 0.8 * lens);
    EXPECT_NEAR(discretisation_error(result).intersection / lost, 1, 0.02);
  }
}

// From the outside and from the inside, at random; in some the polygons do not cross at all.
TEST(Discretisation, HoldsForNearlyTangentCircles) {
  using std::numbers::pi;
  oracle::Random random(11);
  std::size_t without = 0, within = 0, pairs = 0;
  for (const bool inside : {false, true}) {
    for (int k = 0; k < 400; ++k) {
      const double r = random.log_uniform(0.3, 3), s = r * random.log_uniform(1.2, 4);
      const double nearer = random.log_uniform(1e-6, 1e-2);
      const double d = inside ? (s - r) * (1 + nearer) : (r + s) * (1 - nearer), to = random.uniform(0, 2 * pi);
      const auto circle = [&](Point centre, double radius) {
        std::vector<Point> points(static_cast<std::size_t>(random.log_uniform(50, 2000)));
        const double phase = random.uniform(0, 2 * pi), step = 2 * pi / static_cast<double>(points.size());
        for (std::size_t j = 0; j < points.size(); ++j) {
          const double angle = phase + static_cast<double>(j) * step;
          points[j] = {centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)};
        }
        return points;
      };
      const std::vector<Point> first = circle({0, 0}, r), second = circle({d * std::cos(to), d * std::sin(to)}, s);
      const double common = thin_lens_area(r, s, d), lens = inside ? pi * r * r - common : common;
      const Overlay result = overlay(CurveView{first}, CurveView{second});
      const Areas estimate = discretisation_error(result);
      const double lost = std::fabs(lens - (inside ? result.areas.c1_minus_c2 : result.areas.intersection));
      const double estimated = inside ? estimate.c1_minus_c2 : estimate.intersection;
      EXPECT_GE(estimated + 1e-13, 0.5 * lost) << inside << ' ' << k << ' ' << result.nodes.crossings();
      without += result.nodes.crossings() == 0 ? 1 : 0;
      within += estimated <= 2 * lost + 1e-13 ? 1 : 0;
      ++pairs;
    }
  }
  EXPECT_GT(without, 50U);
  EXPECT_GT(within, pairs * 2 / 3);
}

// Circles that stay apart by more than their arcs are high, outside of each other and one in the other.
TEST(Discretisation, SeesNoLensBetweenCurvesThatStayApart) {
  const std::vector<Point> first = ellipse(100, 0, 0, 1, 1), second = ellipse(80, 2.01, 0, 1, 1);
  EXPECT_EQ(discretisation_error(overlay(CurveView{first}, CurveView{second})).intersection, 0);
  const std::vector<Point> inner = ellipse(80, 0.48, 0, 0.5, 0.5);
  const Overlay nested = overlay(CurveView{first}, CurveView{inner});
  EXPECT_EQ(discretisation_error(nested).c2_minus_c1, 0);
}

TEST(Discretisation, IsTheSameWhereVerticesAreRepeated) {
  const std::vector<Point> first = ellipse(200, 0, 0, 1, 1), second = ellipse(150, 1, 0.3, 1, 1);
  std::vector<Point> repeated;
  for (std::size_t k = 0; k < first.size(); ++k)
    repeated.insert(repeated.end(), 1 + (k % 5 == 0 ? 3 : k % 2), first[k]);
  const Areas once = discretisation_error(overlay(CurveView{first}, CurveView{second}));
  for (const bool swapped : {false, true}) {
    const Areas often = swapped ? discretisation_error(overlay(CurveView{second}, CurveView{repeated}))
                                : discretisation_error(overlay(CurveView{repeated}, CurveView{second}));
    EXPECT_NEAR(swapped ? often.c2 : often.c1, once.c1, 1e-15);
    EXPECT_NEAR(often.intersection, once.intersection, 1e-15);
  }
}

TEST(Discretisation, FollowsCurvatureOnUnevenPoints) {
  const double a = 3, b = 0.5;
  std::vector<Point> curve = ellipse(4000, 0, 0, a, b);
  std::erase_if(curve, [k = 0U](const Point&) mutable { return k++ % 7 == 3; });
  const std::vector<Point> far = ellipse(50, 100, 0, 1, 1);
  const Overlay result = overlay(CurveView{curve}, CurveView{far});
  const double lost = std::numbers::pi * a * b - result.areas.c1;
  EXPECT_NEAR(discretisation_error(result).c1 / lost, 1, 0.02);
}

TEST(Discretisation, TakesCornersForCorners) {
  const std::vector<Point> square{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, other{{1, 1}, {9, 1}, {9, 2}, {1, 2}};
  const Areas estimate = discretisation_error(overlay(CurveView{square}, CurveView{other}));
  EXPECT_EQ(estimate.c1, 0);
  EXPECT_EQ(estimate.intersection, 0);
}

TEST(Rounding, BoundsWhatIsTooThinForItsComputedArea) {
  // Found by stress: the curves meet in a sliver of area 1.8642843967860107e-35, computed as 0.
  const std::vector<Point> first{{0x1.4ce478f231b8p-7, 0x1.999999999999ap-3},
                                 {-0x1.4391a276c00bp-4, 0x1.999999999999ap-2},
                                 {-0x1.f0815bb8977bfp-2, 0x1.f5b9dc73fe1c8p-3}},
      second{{0x1.cffb81fe8dbfbp-3, 0x1.6666666666668p-1},
             {0x1.489873f5b3a99p-1, 0x1.6edb96b49d336p-1},
             {-0x1.4391a276c00afp-4, 0x1.9999999999999p-2}};
  const Overlay thin = overlay(CurveView{first}, CurveView{second});
  EXPECT_EQ(thin.pieces(Pairing::intersection).size(), 1U);
  EXPECT_GE(thin.rounding.intersection, std::fabs(thin.areas.intersection - 1.8642843967860107e-35));
  // Empty regions are exact: squares side by side, inside each other, the same.
  const std::vector<Point> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, beside{{1, 0}, {2, 0}, {2, 1}, {1, 1}},
      within{{0.25, 0.25}, {0.5, 0.25}, {0.5, 0.5}};
  EXPECT_EQ(overlay(CurveView{square}, CurveView{beside}).rounding.intersection, 0);
  EXPECT_EQ(overlay(CurveView{square}, CurveView{within}).rounding.c2_minus_c1, 0);
  EXPECT_EQ(overlay(CurveView{square}, CurveView{square}).rounding.symmetric_difference, 0);
}

TEST(Centroids, OfPiecesWithAndWithoutHoles) {
  const std::vector<Point> outer{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, inner{{1, 4}, {3, 4}, {3, 6}, {1, 6}};
  const Overlay nested = overlay(CurveView{outer}, CurveView{inner});
  const Piece ring = nested.pieces(Pairing::c1_minus_c2)[0];
  EXPECT_EQ(ring.holes, 1U);
  EXPECT_EQ(ring.area, 96);
  const Point centre = centroids(nested, Pairing::c1_minus_c2)[0];
  EXPECT_NEAR(centre.x, (100 * 5 - 4 * 2) / 96.0, 1e-14);
  EXPECT_NEAR(centre.y, 5, 1e-14);
  EXPECT_EQ(outline(nested, Pairing::c1_minus_c2, 0).size(), 2U);
}

TEST(Slivers, AreCountedApartFromLobes) {
  // Curves that share half of a circle up to one unit in the last place, and differ visibly on the other half.
  std::vector<Point> first = ellipse(2000, 0, 0, 1, 1), second = first;
  for (std::size_t k = 1; k < 1000; ++k) {
    if (k % 3 != 0) second[k].x = std::nextafter(second[k].x, k % 3 == 1 ? 9 : -9);
  }
  for (std::size_t k = 1001; k < 2000; ++k) {
    const double chord_area = 1 + 0.1 * std::sin(std::numbers::pi * 3 * static_cast<double>(k - 1000) / 1000);
    second[k] = {second[k].x * chord_area, second[k].y * chord_area};
  }
  const Overlay result = overlay(CurveView{first}, CurveView{second});
  std::size_t significant = 0;
  for (const Pairing pairing : {Pairing::c1_minus_c2, Pairing::c2_minus_c1}) {
    const Slivers slivers = find_slivers(result, pairing);
    significant += result.pieces(pairing).size() - slivers.pieces.size();
    EXPECT_GT(slivers.pieces.size(), 50U);
    EXPECT_LT(slivers.area, 1e-15);
    EXPECT_GT(slivers.area, 0);
  }
  EXPECT_EQ(significant, 3U) << "three half waves";
}

TEST(Overlay, ReportsProgressAndCanBeCancelled) {
  const std::vector<Point> first = ellipse(100, 0, 0, 1, 1), second = ellipse(100, 1, 0, 1, 1);
  OverlayOptions options;
  std::vector<double> seen;
  options.progress = [&](double fraction) { return seen.push_back(fraction), true; };
  (void)overlay(CurveView{first}, CurveView{second}, options);
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  EXPECT_EQ(seen.back(), 1);
  options.progress = [](double) { return false; };
  EXPECT_THROW((void)overlay(CurveView{first}, CurveView{second}, options), Cancelled);
}

TEST(Overlay, TotalsAloneAreTheSameBits) {
  const std::vector<Point> first = ellipse(3000, 0, 0, 1, 1), second = ellipse(2000, 1, 0.3, 1.2, 0.7);
  OverlayOptions totals;
  totals.pieces = false;
  const Overlay with = overlay(CurveView{first}, CurveView{second}),
                without = overlay(CurveView{first}, CurveView{second}, totals);
  EXPECT_EQ(with.areas.intersection, without.areas.intersection);
  EXPECT_EQ(with.areas.c1_minus_c2, without.areas.c1_minus_c2);
  EXPECT_EQ(without.pieces(Pairing::intersection).size(), 0U);
}

TEST(Overlay, RefusesCoordinatesThatAreNotFinite) {
  std::vector<Point> first = ellipse(100, 0, 0, 1, 1);
  const std::vector<Point> second = ellipse(100, 1, 0, 1, 1);
  for (const double bad : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    for (std::size_t k = 0; k < first.size(); ++k) {
      std::vector<Point> broken = first;
      (k % 2 == 0 ? broken[k].x : broken[k].y) = bad;
      EXPECT_THROW((void)overlay(CurveView{broken}, CurveView{second}), DataError) << "vertex " << k;
    }
  }
}

}  // namespace
}  // namespace lober::test
