// Passes near the intersections with another curve, and vertices at them.

#include <gtest/gtest.h>

#include <random>

#include "engine/base/parallel/parallel.hpp"
#include "kernels/box.hpp"
#include "kernels/predicates.hpp"
#include "lober/curve/densify.hpp"
#include "tests/engine/geometry/densify/shapes.hpp"
#include "tests/shapes.hpp"

namespace lober::densify_test {
namespace {

using test::circle;

// Brute force: whether segment a b (without b) meets some segment of the other curve.
bool meets(Point a, Point b, CurveView other) {
  PredicateCounts counts;
  for (std::size_t k = 0; k < other.segments(); ++k) {
    const auto [c, d] = other.segment(k);
    const int sc = orient2d(a, b, c, counts), sd = orient2d(a, b, d, counts);
    const int sa = orient2d(c, d, a, counts), sb = orient2d(c, d, b, counts);
    if (sa * sb < 0 && sc * sd < 0) return true;
    if (on_segment(c, d, a, counts) && !(a == d)) return true;
    if (on_segment(a, b, c, counts) && !(c == b)) return true;
  }
  return false;
}

TEST(DensifyNear, PassesReachTheirPrecision) {
  const std::vector<Point> given = circle(60, {0, 0}, 2, 0.1), other = circle(70, {1, 0.3}, 2, 0.2);
  for (const Interpolation interpolation : {Interpolation::linear, Interpolation::dritschel, Interpolation::spline}) {
    for (const auto& [passes, points] : {std::pair{1, 10}, {3, 10}, {2, 100}, {5, 1}}) {
      const NearOptions options{.passes = passes, .points = points, .interpolation = interpolation};
      const DensifiedCurve dense = densify_near({given, true}, {other, true}, options);
      EXPECT_TRUE(keeps(given, dense.points));
      const double longest = distance(given[0], given[1]);
      int met = 0;
      for (std::size_t k = 0; k < dense.points.size(); ++k) {
        const auto [a, b] = CurveView(dense).segment(k);
        if (!meets(a, b, {other, true})) continue;
        ++met;
        EXPECT_LE(distance(a, b), 1.2 * longest * std::pow(points + 1, -passes));  // a cubic is longer than its chord
      }
      EXPECT_EQ(met, 2);
      EXPECT_EQ(dense.points.size(), given.size() + 2U * static_cast<unsigned>(passes * points));
    }
  }
}

TEST(DensifyNear, LinearPointsLieOnTheChords) {
  const std::vector<Point> square{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, other{{1, -1}, {3, 1}, {1, 3}, {-1, 1}};
  const DensifiedCurve dense = densify_near({square, true}, {other, true}, {.passes = 2, .points = 3});
  for (const Point& p : dense.points) EXPECT_TRUE(p.x == 0 || p.y == 0 || p.x == 4 || p.y == 4);
  // The square is crossed at (2, 0) and (0, 2), at parameter 1/2 of their segments, where the first pass puts a vertex,
  // and touched at its vertex (0, 0). Segments are taken without their last point, so the parts behind these three are
  // refined.
  EXPECT_EQ(dense.points.size(), 4U + (3 + 2 * 3) + (3 + 3));
}

TEST(DensifyNear, NothingToDo) {
  const std::vector<Point> given = circle(60, {0, 0}, 2, 0.1), far = circle(70, {100, 0}, 2, 0.2);
  EXPECT_TRUE(std::ranges::equal(densify_near({given, true}, {far, true}, {}).points, given));
  const std::vector<Point> other = circle(70, {1, 0}, 2, 0.2);
  EXPECT_EQ(densify_near({given, true}, {other, true}, {.passes = 0, .points = 10}).points.size(), 60U);
  EXPECT_EQ(densify_near({given, true}, {other, true}, {.passes = 10, .points = 0}).points.size(), 60U);
  EXPECT_THROW((void)densify_near({given, true}, {other, true}, {.passes = -1}), UsageError);
  EXPECT_THROW((void)densify_near({given, true}, {other, true}, {.points = 100, .max_points = 100}), DataError);
}

TEST(DensifyNear, OpenCurvesAndTheirEnds) {
  // The last vertex of the open curve lies on the other one.
  const std::vector<Point> open{{0, 0}, {1, 0}, {2, 0}}, wall{{2, -1}, {2, 1}};
  const DensifiedCurve dense = densify_near({open, false}, {wall, false}, {.passes = 3, .points = 1});
  EXPECT_EQ(dense.points.size(), 6U);
  EXPECT_EQ(dense.points[4], (Point{1.875, 0}));
  const auto [first, second] = insert_crossings({open, false}, {wall, false});
  EXPECT_EQ(first.points.size(), 3U);
  ASSERT_EQ(second.points.size(), 3U);
  EXPECT_EQ(second.points[1], (Point{2, 0}));
  const auto [wall_first, open_second] = insert_crossings({wall, false}, {open, false});
  EXPECT_EQ(wall_first.points[1], (Point{2, 0}));
  EXPECT_EQ(open_second.points.size(), 3U);
}

// After the insertion no segment of one curve crosses one of the other inside both: they meet in common vertices.
TEST(InsertCrossings, CurvesMeetInCommonVerticesOnly) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int round = 0; round < 20; ++round) {
    std::vector<Point> first, second;
    for (int k = 0; k < 12; ++k) {
      first.push_back({unit(random), unit(random)});
      second.push_back({unit(random), unit(random)});
    }
    const bool closed = round % 2 == 0;
    const auto [a, b] = insert_crossings({first, closed}, {second, true});
    EXPECT_TRUE(keeps(first, a.points));
    EXPECT_TRUE(keeps(second, b.points));
    // As many as brute force counts, and each in both.
    std::size_t expected = 0;
    PredicateCounts counts;
    const CurveView c1{first, closed}, c2{second, true};
    for (std::size_t i = 0; i < c1.segments(); ++i) {
      for (std::size_t j = 0; j < c2.segments(); ++j) {
        const auto [p, q] = c1.segment(i);
        const auto [r, s] = c2.segment(j);
        expected += orient2d(p, q, r, counts) * orient2d(p, q, s, counts) < 0 &&
                            orient2d(r, s, p, counts) * orient2d(r, s, q, counts) < 0
                        ? 1
                        : 0;
      }
    }
    EXPECT_EQ(a.points.size(), first.size() + expected);
    EXPECT_EQ(b.points.size(), second.size() + expected);
    std::size_t common = 0;
    for (const Point& p : a.points) common += std::find(b.points.begin(), b.points.end(), p) != b.points.end() ? 1 : 0;
    EXPECT_EQ(common, expected);
    // In order along each chord: the way along the inserted points is no longer than the chord.
    const auto length = [](CurveView curve) {
      double sum = 0;
      for (std::size_t k = 0; k < curve.segments(); ++k) sum += distance(curve.segment(k).a, curve.segment(k).b);
      return sum;
    };
    EXPECT_NEAR(length(a), length(c1), 1e-13);
    EXPECT_NEAR(length(b), length(c2), 1e-13);
  }
}

TEST(InsertCrossings, VerticesAndSharedArcsOnTheOtherCurve) {
  const std::vector<Point> first{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, second{{1, 0}, {3, 0}, {3, 2}, {4, 3}, {1, 5}};
  const auto [a, b] = insert_crossings({first, true}, {second, true});
  // C1 receives (1,0), (3,0), (4,3) and the two crossings of y = 4; C2 those crossings.
  EXPECT_EQ(a.points.size(), 9U);
  EXPECT_EQ(b.points.size(), 7U);
  EXPECT_EQ(a.points[1], (Point{1, 0}));
  EXPECT_EQ(a.points[2], (Point{3, 0}));
  const auto [same1, same2] = insert_crossings({first, true}, {first, true});
  EXPECT_TRUE(std::ranges::equal(same1.points, first));
  EXPECT_TRUE(std::ranges::equal(same2.points, first));
}

TEST(DensifyNear, SameBitsForAnyNumberOfThreads) {
  std::vector<Point> given;
  for (std::size_t k = 0; k < 60'000; ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / 60'000;
    const double radius = 2 + 0.05 * std::sin(3000 * angle);
    given.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  const std::vector<Point> other = circle(50'000, {0, 0}, 2, 0.2);
  for (const Interpolation interpolation : {Interpolation::linear, Interpolation::dritschel, Interpolation::spline}) {
    const auto run = [&] {
      return densify_near({given, true}, {other, true}, {.passes = 2, .points = 5, .interpolation = interpolation});
    };
    const auto cross = [&] { return insert_crossings({given, true}, {other, true}); };
    const DensifiedCurve one = with_threads(1, run);
    const auto crossed = with_threads(1, cross);
    EXPECT_GE(one.points.size(), given.size() + 6000 * 10);
    EXPECT_GE(crossed[0].points.size(), given.size() + 5990);
    for (const int threads : {2, 7}) {
      EXPECT_TRUE(one.points == with_threads(threads, run).points);
      const auto again = with_threads(threads, cross);
      EXPECT_TRUE(crossed[0].points == again[0].points);
      EXPECT_TRUE(crossed[1].points == again[1].points);
    }
  }
}

}  // namespace
}  // namespace lober::densify_test
