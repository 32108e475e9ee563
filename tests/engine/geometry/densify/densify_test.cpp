#include "lober/curve/densify.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "engine/base/parallel/parallel.hpp"
#include "engine/geometry/densify/spline.hpp"
#include "kernels/box.hpp"
#include "tests/engine/geometry/densify/shapes.hpp"

namespace lober::densify_test {
namespace {

constexpr std::array all_interpolations{Interpolation::linear, Interpolation::dritschel, Interpolation::spline};

// ------------------------------------------------------------------------------------------ interpolation

double worst_off_ellipse(const std::vector<Point>& given, bool closed, Interpolation interpolation) {
  const Criteria criteria{.max_length = distance(given[0], given[1]) / 8};
  const DensifiedCurve dense = densify({given, closed}, criteria, {.interpolation = interpolation});
  double worst = 0;
  for (const Point& point : dense.points) worst = std::max(worst, off_ellipse(point));
  return worst;
}

double observed_order(Interpolation interpolation, double uneven, bool closed) {
  const double turn = closed ? 2 * std::numbers::pi : 2;
  const double coarse = worst_off_ellipse(ellipse(100, uneven, turn, closed), closed, interpolation);
  const double fine = worst_off_ellipse(ellipse(400, uneven, turn, closed), closed, interpolation);
  return std::log(coarse / fine) / std::log(4.0);
}

TEST(DensifyInterpolation, OrdersOfConvergence) {
  for (const bool closed : {true, false}) {
    for (const double uneven : {0.0, 0.5}) {
      EXPECT_NEAR(observed_order(Interpolation::linear, uneven, closed), 2, 0.1);
      EXPECT_GT(observed_order(Interpolation::dritschel, uneven, closed), closed ? 3.5 : 2.8);
      EXPECT_GT(observed_order(Interpolation::spline, uneven, closed), 3.8);
    }
  }
}

// The equations of the spline solved densely, all at once.
TEST(DensifyInterpolation, SplineAgreesWithDenseSolve) {
  for (const bool closed : {true, false}) {
    for (const std::size_t size : {4, 5, 9, 300}) {
      const std::vector<Point> points = ellipse(size, 0.4, closed ? 2 * std::numbers::pi : 3, closed);
      const auto n = static_cast<Eigen::Index>(size);
      Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
      Eigen::MatrixXd right = Eigen::MatrixXd::Zero(n, 2);
      const auto at = [&](Eigen::Index k) { return points[static_cast<std::size_t>((k + n) % n)]; };
      const auto h = [&](Eigen::Index k) { return distance(at(k), at(k + 1)); };
      for (Eigen::Index k = closed ? 0 : 1; k < (closed ? n : n - 1); ++k) {
        matrix(k, (k + n - 1) % n) = h(k - 1);
        matrix(k, k) = 2 * (h(k - 1) + h(k));
        matrix(k, (k + 1) % n) = h(k);
        right(k, 0) = 6 * ((at(k + 1).x - at(k).x) / h(k) - (at(k).x - at(k - 1).x) / h(k - 1));
        right(k, 1) = 6 * ((at(k + 1).y - at(k).y) / h(k) - (at(k).y - at(k - 1).y) / h(k - 1));
      }
      if (!closed) {
        for (const auto& [end, near, far, e, f] :
             {std::tuple{Eigen::Index{0}, Eigen::Index{1}, Eigen::Index{2}, h(0), h(1)},
              {n - 1, n - 2, n - 3, h(n - 2), h(n - 3)}}) {
          matrix(end, end) = 1 / e;
          matrix(end, near) = -1 / e - 1 / f;
          matrix(end, far) = 1 / f;
        }
      }
      const Eigen::MatrixXd expected = matrix.fullPivLu().solve(right);
      const Buffer<Point> second = spline_second_derivatives({points, closed});
      for (Eigen::Index k = 0; k < n; ++k) {
        EXPECT_NEAR(second[static_cast<std::size_t>(k)].x, expected(k, 0), 1e-9 * expected.norm()) << size << ' ' << k;
        EXPECT_NEAR(second[static_cast<std::size_t>(k)].y, expected(k, 1), 1e-9 * expected.norm()) << size << ' ' << k;
      }
    }
  }
}

// Blocks of the solver meet without a seam, and a closed curve has none at its first vertex.
TEST(DensifyInterpolation, SplineHasNoSeams) {
  const std::size_t size = 3 * 4096 + 17;
  const Buffer<Point> second = spline_second_derivatives({ellipse(size), true});
  const auto at = [&](std::size_t k) { return second[k % size]; };
  for (std::size_t k = 0; k < size;
       ++k) {  // M is that of the smooth curve, so its second difference is small everywhere
    EXPECT_NEAR(at(k).x + at(k + 2).x, 2 * at(k + 1).x, 2e-4) << k;
  }
}

TEST(DensifyInterpolation, CubicsAreReproduced) {
  // A straight line stays one whatever the interpolation and however uneven its vertices.
  const std::vector<Point> line{{0, 0}, {1, 2}, {1.5, 3}, {10, 20}, {11, 22}};
  for (const Interpolation interpolation : all_interpolations) {
    const DensifiedCurve dense = densify({line, false}, {.max_length = 0.1}, {.interpolation = interpolation});
    for (const Point& point : dense.points) EXPECT_NEAR(point.y, 2 * point.x, 1e-13);
    EXPECT_EQ(dense.points.back(), line.back());
  }
  // Three vertices of an open curve give one parabola over chord length: x and y have constant second derivatives.
  const Buffer<Point> second = spline_second_derivatives({std::vector<Point>{{0, 0}, {3, 4}, {6, 0}}, false});
  EXPECT_EQ(second[0], second[1]);
  EXPECT_EQ(second[2], second[1]);
  EXPECT_NEAR(second[1].y, -8.0 / 25, 1e-15);  // y = s (10 - s) 4 / 25
  EXPECT_NEAR(second[1].x, 0, 1e-15);
}

// ------------------------------------------------------------------------------------------------ criteria

TEST(DensifyCriteria, DistanceHoldsAndNothingIsLost) {
  for (const Interpolation interpolation : all_interpolations) {
    for (const bool closed : {true, false}) {
      const std::vector<Point> given = ellipse(57, 0.6, closed ? 2 * std::numbers::pi : 4, closed);
      for (const double longest : {0.3, 0.04, 0.0021}) {
        const DensifiedCurve dense =
            densify({given, closed}, {.max_length = longest}, {.interpolation = interpolation});
        EXPECT_LE(extremes(dense).max_length, longest * (1 + 1e-12));
        EXPECT_TRUE(keeps(given, dense.points));
        EXPECT_TRUE(dense.diagnostics.empty());
        EXPECT_EQ(dense.closed, closed);
        // Not many more than needed: perimeter over length, and what is lost to whole numbers.
        const double perimeter = closed ? 9.69 : 9.69 * 0.7;
        EXPECT_LT(static_cast<double>(dense.points.size()), 1.5 * perimeter / longest + 60) << name(interpolation);
      }
    }
  }
}

TEST(DensifyCriteria, LinearPartsAreAsFewAsPossible) {
  const std::vector<Point> given{{0, 0}, {1, 0}, {1, 0.25}, {0, 0.25}};
  const DensifiedCurve dense = densify({given, true}, {.max_length = 0.25});
  const std::vector<Point> expected{{0, 0},    {0.25, 0},    {0.5, 0},    {0.75, 0},    {1, 0},
                                    {1, 0.25}, {0.75, 0.25}, {0.5, 0.25}, {0.25, 0.25}, {0, 0.25}};
  EXPECT_TRUE(std::equal(dense.points.begin(), dense.points.end(), expected.begin(), expected.end()));
}

TEST(DensifyCriteria, AnglesHold) {
  for (const Interpolation interpolation : {Interpolation::dritschel, Interpolation::spline}) {
    for (const bool closed : {true, false}) {
      const std::vector<Point> given = ellipse(31, 0.6, closed ? 2 * std::numbers::pi : 4, closed);
      for (const auto& [angle, distance_angle] :
           {std::pair{0.1, Criteria::off}, {Criteria::off, 1e-3}, {0.3, 1e-3}, {0.01, 1e-5}}) {
        // Dritschel's tangents do not quite agree at the vertices of so coarse a curve.
        if (interpolation == Interpolation::dritschel && angle == 0.01) continue;
        const Criteria criteria{.angle = angle, .distance_angle = distance_angle, .min_length = 1e-6};
        const DensifiedCurve dense = densify({given, closed}, criteria, {.interpolation = interpolation});
        const Extremes found = extremes(dense);
        EXPECT_LE(found.angle, angle * (1 + 1e-9)) << name(interpolation) << closed;
        EXPECT_LE(found.distance_angle, distance_angle * (1 + 1e-9)) << name(interpolation) << closed;
        EXPECT_TRUE(dense.diagnostics.empty());
        EXPECT_TRUE(keeps(given, dense.points));
        EXPECT_GT(dense.points.size(), given.size());
      }
    }
  }
}

// Every segment that breaks a criterion, and no other, is in a diagnostic. (Linear interpolation keeps the corners.)
TEST(DensifyCriteria, CornersAreRefinedUntilDistanceTimesAngleHolds) {
  const std::vector<Point> given{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const Criteria criteria{.distance_angle = 1e-4, .min_length = 1e-3};
  const DensifiedCurve dense = densify({given, true}, criteria);
  EXPECT_GE(extremes(dense).min_length, 1e-3 * (1 - 1e-9));
  EXPECT_EQ(dense.points.size(), 4000U);
  ASSERT_EQ(dense.diagnostics.size(), 4U);
  for (std::uint32_t k = 0; k < 4; ++k)
    EXPECT_EQ(dense.diagnostics[k], (Diagnostic{1000 * k, 1000, DiagnosticCause::min_length}));
  // With a lower floor the criterion can be met.
  const DensifiedCurve finer = densify({given, true}, {.distance_angle = 1e-4, .min_length = 1e-6});
  EXPECT_TRUE(finer.diagnostics.empty());
  EXPECT_LE(extremes(finer).distance_angle, 1e-4 * (1 + 1e-9));
}

TEST(DensifyCriteria, CornersOfTheInterpolationAreReportedAndNotPursued) {
  const std::vector<Point> given{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
  for (const Interpolation interpolation : {Interpolation::dritschel, Interpolation::spline}) {
    const Criteria criteria{.angle = 0.05, .min_length = 1e-3};
    const DensifiedCurve dense = densify({given, true}, criteria, {.interpolation = interpolation});
    EXPECT_LT(dense.points.size(), 2000U);  // down to the floor everywhere it would be 8000
    EXPECT_EQ(dense.diagnostics.empty(), interpolation == Interpolation::spline);  // the spline has no corners
    std::vector<bool> with_diagnostic(dense.points.size());
    for (const Diagnostic& diagnostic : dense.diagnostics) {
      for (std::uint32_t k = 0; k < diagnostic.count; ++k) with_diagnostic[diagnostic.first + k] = true;
    }
    for (std::size_t k = 0; k < dense.points.size(); ++k) {
      const std::size_t next = (k + 1) % dense.points.size(), then = (k + 2) % dense.points.size();
      if (angle_at(dense.points[k], dense.points[next], dense.points[then]) > 0.05 * (1 + 1e-9)) {
        EXPECT_TRUE(with_diagnostic[k] || with_diagnostic[next]) << name(interpolation) << k;
      }
    }
  }
}

TEST(DensifyCriteria, LimitsAreKeptAndReported) {
  const std::vector<Point> given = ellipse(50);
  for (const Interpolation interpolation : all_interpolations) {
    const DensifiedCurve dense =
        densify({given, true}, {.max_length = 1e-4}, {.interpolation = interpolation, .max_points = 1000});
    EXPECT_LE(dense.points.size(), 1000U);
    EXPECT_GT(dense.points.size(), 900U);
    ASSERT_EQ(dense.diagnostics.size(), 50U);
    for (const Diagnostic& diagnostic : dense.diagnostics) EXPECT_EQ(diagnostic.cause, DiagnosticCause::max_points);
    const DensifiedCurve none = densify({given, true}, {.max_length = 1e-4}, {.max_points = 10});
    EXPECT_EQ(none.points.size(), 50U);
    EXPECT_EQ(none.diagnostics.size(), 50U);
  }
  const DensifiedCurve huge = densify({given, true}, {.max_length = 1e-300}, {.max_points = 2000});
  EXPECT_LE(huge.points.size(), 2000U);
}

TEST(DensifyCriteria, FewAndRepeatedVertices) {
  for (const Interpolation interpolation : all_interpolations) {
    const DensifyOptions options{.interpolation = interpolation};
    const std::vector<Point> two{{0, 0}, {0, 0}, {1, 0}, {1, 0}};
    const DensifiedCurve line = densify({two, false}, {.max_length = 0.5}, options);
    ASSERT_EQ(line.points.size(), 3U);
    EXPECT_EQ(line.points[1], (Point{0.5, 0}));
    const std::vector<Point> three{{0, 0}, {1, 0}, {1, 0}, {0, 1}, {0, 0}};
    const DensifiedCurve triangle = densify({three, true}, {.max_length = 0.6}, options);
    EXPECT_TRUE(keeps(std::vector<Point>{{0, 0}, {1, 0}, {0, 1}}, triangle.points));
    EXPECT_LE(extremes(triangle).max_length, 0.6);
    EXPECT_GT(extremes(triangle).min_length, 0);
    const DensifiedCurve open =
        densify({std::vector<Point>{{0, 0}, {1, 0}, {1, 1}}, false}, {.max_length = 0.1}, options);
    EXPECT_LE(extremes(open).max_length, 0.1 * (1 + 1e-12));
  }
}

TEST(DensifyCriteria, BadInputIsRefused) {
  const std::vector<Point> good = ellipse(10);
  const double nan = std::nan("");
  EXPECT_THROW((void)densify({good, true}, {.max_length = 0}), UsageError);
  EXPECT_THROW((void)densify({good, true}, {.max_length = nan}), UsageError);
  EXPECT_THROW((void)densify({good, true}, {.min_length = -1}), UsageError);
  EXPECT_THROW((void)densify({good, true}, {.angle = 0.3, .min_length = 1e-3}), UsageError);  // linear
  EXPECT_THROW((void)densify({good, true}, {.distance_angle = 0.3}), UsageError);             // no floor
  EXPECT_THROW((void)densify({std::vector<Point>{{0, 0}, {1, 1}}, true}, {.max_length = 1}), DataError);
  EXPECT_THROW((void)densify({std::vector<Point>{{0, 0}}, false}, {.max_length = 1}), DataError);
  EXPECT_THROW((void)densify({std::vector<Point>{{0, 0}, {nan, 1}, {2, 2}}, false}, {.max_length = 1}), DataError);
}

TEST(DensifyCriteria, HobsonDefaultsScaleWithTheCurve) {
  const Criteria criteria = hobson_criteria({ellipse(400), true});
  EXPECT_EQ(criteria.angle, 0.3);
  EXPECT_NEAR(criteria.distance_angle, 4e-3, 1e-6);
  EXPECT_NEAR(criteria.min_length, 4e-6, 1e-9);
}

TEST(DensifyCriteria, SameBitsForAnyNumberOfThreads) {
  const std::vector<Point> given = ellipse(40'000, 0.7);
  for (const Interpolation interpolation : all_interpolations) {
    Criteria criteria{.max_length = 1e-4, .distance_angle = 1e-9, .min_length = 1e-6};
    if (interpolation == Interpolation::linear) criteria.distance_angle = 2e-8;
    const auto run = [&] { return densify({given, true}, criteria, {.interpolation = interpolation}); };
    const DensifiedCurve one = with_threads(1, run);
    for (const int threads : {2, 7}) {
      const DensifiedCurve more = with_threads(threads, run);
      EXPECT_TRUE(one.points == more.points);
      EXPECT_TRUE(one.diagnostics == more.diagnostics);
      EXPECT_EQ(one.rounds, more.rounds);
    }
  }
}

}  // namespace
}  // namespace lober::densify_test
