// Curves that are not simple are refused, with the place; all others are not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "engine/base/stopwatch.hpp"
#include "lober/overlay/crossings.hpp"
#include "tests/shapes.hpp"

namespace lober::test {
namespace {

using detail::with_threads;
NotSimpleError not_simple(const Points& points) {
  try {
    require_simple(IndexedCurve(CurveView{points}), 1);
  } catch (const NotSimpleError& error) {
    return error;
  }
  ADD_FAILURE() << "not refused";
  return {0, 0, 0, {}};
}

TEST(RequireSimple, NamesTheCrossing) {
  const NotSimpleError error = not_simple({{0, 0}, {4, 4}, {4, 0}, {0, 4}});
  EXPECT_EQ(error.segment1, 0U);
  EXPECT_EQ(error.segment2, 2U);
  EXPECT_EQ(error.at, (Point{2, 2}));
}

TEST(RequireSimple, RefusesTouchesSpikesAndOverlaps) {
  EXPECT_EQ(not_simple({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}).at, (Point{2, 0})) << "a vertex on a segment";
  EXPECT_EQ(not_simple({{0, 0}, {2, 2}, {4, 0}, {4, 4}, {2, 2}, {0, 4}}).at, (Point{2, 2})) << "a vertex twice";
  (void)not_simple({{0, 0}, {4, 0}, {8, 0}, {4, 0}, {4, 4}});  // out and back
  (void)not_simple({{0, 0}, {6, 0}, {3, 0}, {3, 4}});          // a spike
  (void)not_simple({{0, 0}, {6, 0}, {6, 2}, {5, 0}, {1, 0}, {0, 4}});
}

TEST(RequireSimple, AcceptsRepeatedVerticesAndStraightAngles) {
  for (const Points& points :
       {Points{{0, 0}, {1, 0}, {0, 1}}, Points{{0, 0}, {0, 0}, {1, 0}, {2, 0}, {2, 0}, {2, 0}, {0, 1}, {0, 0}},
        Points{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 1}}}) {
    EXPECT_NO_THROW(require_simple(IndexedCurve(CurveView{points}), 1));
  }
}

TEST(RequireSimple, FindsOneBadPlaceAmongManySegments) {
  Points points(50000);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(points.size());
    points[k] = {std::cos(angle), std::sin(angle)};
  }
  EXPECT_NO_THROW(require_simple(IndexedCurve(CurveView{points}), 1));
  for (const std::size_t k :
       {std::size_t{0}, std::size_t{31}, std::size_t{32}, std::size_t{12345}, std::size_t{49998}}) {
    Points bent = points;
    std::swap(bent[k], bent[k + 1]);  // a loop of three segments
    const NotSimpleError error = not_simple(bent);
    EXPECT_NEAR(std::hypot(error.at.x - points[k].x, error.at.y - points[k].y), 0, 1e-3);
  }
}

// The first of many pairs counts, whichever thread finds what.
TEST(RequireSimple, NamesTheFirstOfManyBadPlaces) {
  Points points(200'000);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(points.size());
    points[k] = {std::cos(angle), std::sin(angle)};
  }
  for (const std::size_t first : {std::size_t{3}, std::size_t{2040}, std::size_t{70'001}, std::size_t{150'000}}) {
    Points bent = points;
    for (std::size_t k = first; k + 1 < bent.size(); k += 517) std::swap(bent[k], bent[k + 1]);
    for (const int threads : {1, 2, 7}) {
      const NotSimpleError error = with_threads(threads, [&] { return not_simple(bent); });
      EXPECT_EQ(error.segment1, first == 0 ? 0 : first - 1) << threads;
      EXPECT_EQ(error.segment2, first + 1) << threads;
    }
  }
}

// Every second point at the origin, as of a file whose pages came as zeros: each segment meets each other one there.
// Eight times the points take about four times as long; all pairs would take 64 times.
TEST(RequireSimple, EndsSoonWhereEverythingMeets) {
  const auto seconds = [](std::size_t size) {
    Points points(size);
    for (std::size_t k = 0; k < size; k += 2) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(size);
      points[k] = {std::cos(angle), std::sin(angle)};
    }
    std::vector<double> times;
    for (int round = 0; round < 3; ++round) {
      const detail::Stopwatch watch;
      const NotSimpleError error = not_simple(points);
      times.push_back(watch.seconds());
      EXPECT_EQ(error.segment1, 0U);
      EXPECT_EQ(error.at, (Point{0, 0}));
    }
    std::sort(times.begin(), times.end());
    return times[1];
  };
  EXPECT_LT(seconds(400'000), 25 * seconds(50'000));
}

// Folds side by side, bent round half a turn, enough of them that windows are searched: out along every second one,
// back along the next.
constexpr std::size_t fold_pairs = 512, points_a_fold = 250;
Points folded() {
  Points points;
  for (std::size_t k = 0; k < 2 * fold_pairs; ++k) {
    const double radius = 2 - static_cast<double>(k) / static_cast<double>(2 * fold_pairs);
    for (std::size_t j = 0; j < points_a_fold; ++j) {
      const double angle =
          3 * static_cast<double>(k % 2 == 0 ? j : points_a_fold - 1 - j) / static_cast<double>(points_a_fold);
      points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
  }
  points.push_back({0.9, -0.1});
  points.push_back({2.1, -0.1});
  return points;
}

// Defects at ends and in the middle of leaves, along folds and where they end.
TEST(RequireSimple, FindsOneBadPlaceAmongFolds) {
  const Points points = folded();
  EXPECT_NO_THROW(require_simple(IndexedCurve(CurveView{points}), 1));
  for (const std::size_t place :
       {1U, 31U, 32U, 33U, 63U, 64U, 249U, 250U, 65536U, 131199U, 131200U, 200001U, 255998U}) {
    const std::size_t k = place;
    Points bad = points;
    bad[k + 1] = bad[k - 1];
    const NotSimpleError spike = not_simple(bad);
    EXPECT_LE(spike.segment1, k) << "out and back at " << k;
    bad = points;
    std::swap(bad[k], bad[k + 1]);
    if (k % points_a_fold != 0) {  // where a fold begins this is not a loop
      const NotSimpleError loop = not_simple(bad);
      EXPECT_NEAR(std::hypot(loop.at.x - points[k].x, loop.at.y - points[k].y), 0, 0.05) << "a small loop at " << k;
    }
    bad = points;
    bad[k] = bad[k - 1];
    EXPECT_NO_THROW(require_simple(IndexedCurve(CurveView{bad}), 1)) << "a point twice at " << k;
    if (k > 2 * points_a_fold) {
      // Onto the fold beside it: the one before, at the same angle.
      const std::size_t j = k % points_a_fold, beside = k / points_a_fold * points_a_fold - 1 - j;
      bad = points;
      bad[k] = bad[beside];
      const NotSimpleError touch = not_simple(bad);
      EXPECT_LE(touch.segment1, beside);
      EXPECT_NEAR(static_cast<double>(touch.segment2), static_cast<double>(k), 1);
    }
  }
}

// A turn by less than a right angle has nothing in common beyond its joint; by more, it may lie upon itself.
TEST(RequireSimple, LooksAtJointsThatTurnBack) {
  for (const double back : {0.0, 1e-300, 1e-17, 1e-3, 0.5}) {
    // From (1, 1) on to (0, 0) and straight back along the same line, or off it by the least there is.
    (void)not_simple({{1, 1}, {0, 0}, {1 - back, 1 - back}, {1 - back, -3}, {3, -3}});
    EXPECT_NO_THROW(require_simple(
        IndexedCurve(CurveView{Points{{1, 1}, {0, 0}, {0.5, std::nextafter(0.5, 0)}, {0.5, -3}, {3, -3}}}), 1));
  }
}

TEST(RequireSimple, SkipsMonotoneRuns) {
  Points points(50000);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(points.size());
    points[k] = {std::cos(angle), std::sin(angle)};
  }
  EXPECT_LT(require_simple(IndexedCurve(CurveView{points}), 1).pairs, 1000U) << "of 50000 segments";
}

}  // namespace
}  // namespace lober::test
