#include <gtest/gtest.h>

#include <random>

#include "engine/base/parallel/parallel.hpp"
#include "kernels/box.hpp"
#include "lober/curve/curve.hpp"
#include "lober/curve/densify.hpp"
#include "tests/distance.hpp"
#include "tests/engine/geometry/densify/shapes.hpp"

namespace lober::densify_test {
namespace {

// Walks both curves together: how far each vertex given is from the segment of the result that spans it.
double worst_deviation(std::span<const Point> given, CurveView result) {
  double worst = 0;
  std::size_t segment = 0;
  for (const Point& point : given) {
    if (segment + 1 < result.points.size() && point == result.points[segment + 1]) ++segment;
    if (segment == result.segments()) return std::max(worst, point == result.points.back() ? 0 : Criteria::off);
    worst = std::max(worst, distance_to_segment(point, result.segment(segment).a, result.segment(segment).b));
  }
  return segment + 1 >= result.segments() ? worst : Criteria::off;
}

TEST(Thin, StaysWithinToleranceAndKeepsEnds) {
  for (const bool closed : {true, false}) {
    for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
      const std::vector<Point> given = ellipse(5000, 0.6, closed ? 2 * std::numbers::pi : 5, closed);
      const DensifiedCurve simplified = simplify({given, closed}, {.tolerance = tolerance});
      EXPECT_TRUE(keeps(simplified.points, given));
      EXPECT_LE(worst_deviation(given, simplified), tolerance * (1 + 1e-9));
      // A polygon within this of a unit curvature needs about L / sqrt(8 tolerance) vertices.
      const double needed = 9.69 / std::sqrt(8 * tolerance);
      EXPECT_LT(static_cast<double>(simplified.points.size()), 4 * needed + 10);
      if (!closed) {
        EXPECT_EQ(simplified.points.back(), given.back());
      }
    }
  }
}

TEST(Thin, NoisyCurves) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> noise(0, 1e-3);
  std::vector<Point> given = ellipse(3000);
  for (Point& point : given) point = {point.x + noise(random), point.y + noise(random)};
  for (const double tolerance : {1e-4, 1e-3, 1e-2, 1.0, 100.0}) {
    const DensifiedCurve simplified = simplify({given, true}, {.tolerance = tolerance});
    EXPECT_LE(worst_deviation(given, simplified), tolerance * (1 + 1e-9));
    EXPECT_GE(simplified.points.size(), 3U);
    validate(simplified, "simplified");
  }
}

TEST(Thin, LongestHolds) {
  const std::vector<Point> given = ellipse(5000);
  const DensifiedCurve simplified = simplify({given, true}, {.tolerance = 0.1, .max_length = 0.05});
  EXPECT_LE(extremes(simplified).max_length, 0.05);
  EXPECT_LT(simplified.points.size(), 500U);
}

TEST(Thin, ZeroToleranceRemovesWhatIsOnTheLine) {
  const std::vector<Point> given{{0, 0}, {1, 0}, {2, 0}, {2, 0}, {3, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 2}};
  const DensifiedCurve simplified = simplify({given, true}, {});
  const std::vector<Point> expected{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  EXPECT_TRUE(std::ranges::equal(simplified.points, expected));
}

// A closed curve keeps three vertices that another command reads.
TEST(Thin, ClosedCurvesOnALineKeepThreeVertices) {
  for (const std::vector<Point>& line :
       {std::vector<Point>{{0, 0}, {1, 1}, {2, 2}}, std::vector<Point>{{0, 0}, {1, 1}, {3, 3}, {2, 2}}}) {
    const DensifiedCurve found = simplify(CurveView{line}, {.tolerance = 0});
    EXPECT_EQ(found.points.size(), 3U);
    EXPECT_NO_THROW(validate(CurveView{found.points}, "simplified"));
  }
}

TEST(Thin, SpikesStay) {
  // A spike doubles back over its own line: its end is on no segment between its feet.
  const std::vector<Point> given{{0, 0}, {1, 0}, {5, 0}, {2, 0}, {3, 0}};
  const DensifiedCurve simplified = simplify({given, false}, {.tolerance = 0.5});
  EXPECT_LE(worst_deviation(given, simplified), 0.5);
  EXPECT_NE(std::find(simplified.points.begin(), simplified.points.end(), Point{5, 0}), simplified.points.end());
}

// Squares of lengths would be zero or infinite.
TEST(Thin, TinyAndHugeCurves) {
  const std::vector<Point> usual{{0, 0}, {1, 0}, {2, 0}, {2, 1.5}, {2, 2}, {0, 2}};
  for (const int exponent : {-1000, -560, -537, 512, 1000}) {
    std::vector<Point> given, corners;
    for (const Point& p : usual) given.push_back({std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)});
    for (const std::size_t k : {0, 2, 4, 5}) corners.push_back(given[k]);
    EXPECT_TRUE(std::ranges::equal(simplify({given, true}, {}).points, corners)) << exponent;
    const double tolerance = std::ldexp(0.25, exponent);
    EXPECT_TRUE(std::ranges::equal(simplify({given, true}, {.tolerance = tolerance}).points, corners)) << exponent;
    const double side = std::ldexp(0.5, exponent);
    const DensifiedCurve dense = densify({corners, true}, {.max_length = side});
    EXPECT_EQ(dense.points.size(), 16U) << exponent;
    EXPECT_TRUE(dense.points[1] == (Point{side, 0})) << exponent;
    EXPECT_TRUE(dense.diagnostics.empty()) << exponent;
    const DensifiedCurve round =
        densify({given, true}, hobson_criteria({given, true}), {.interpolation = Interpolation::dritschel});
    const DensifiedCurve usual_round =
        densify({usual, true}, hobson_criteria({usual, true}), {.interpolation = Interpolation::dritschel});
    EXPECT_NEAR(static_cast<double>(round.points.size()), static_cast<double>(usual_round.points.size()), 2)
        << exponent;
  }
}

TEST(Thin, BadOptions) {
  const std::vector<Point> given = ellipse(10);
  EXPECT_THROW((void)simplify({given, true}, {.tolerance = -1}), UsageError);
  EXPECT_THROW((void)simplify({given, true}, {.tolerance = std::nan("")}), UsageError);
  EXPECT_THROW((void)simplify({given, true}, {.max_length = 0}), UsageError);
}

TEST(Thin, UndoesDensify) {
  const std::vector<Point> given = ellipse(100);
  const DensifiedCurve dense = densify({given, true}, {.max_length = 0.01});
  const DensifiedCurve simplified = simplify(dense, {.tolerance = 1e-12});
  EXPECT_TRUE(std::ranges::equal(simplified.points, given));
}

TEST(Thin, SameBitsForAnyNumberOfThreads) {
  const std::vector<Point> given = ellipse(100'000, 0.5);
  const auto run = [&] { return simplify({given, true}, {.tolerance = 1e-7}); };
  const DensifiedCurve one = with_threads(1, run);
  EXPECT_TRUE(one.points == with_threads(2, run).points);
  EXPECT_TRUE(one.points == with_threads(7, run).points);
}

}  // namespace
}  // namespace lober::densify_test
