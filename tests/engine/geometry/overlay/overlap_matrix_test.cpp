// Many curves against many: the numbers of overlay, bit for bit, for every pair, and none missing.
#include "lober/overlay/overlap_matrix.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "lober/base/cancellation.hpp"
#include "lober/overlay/overlay.hpp"
#include "tests/oracle/random.hpp"

namespace lober {
namespace {

using Curves = std::vector<std::vector<Point>>;

std::vector<Point> wavy_curve(double x, double y, double radius, int points, int waves) {
  std::vector<Point> curve;
  for (int k = 0; k < points; ++k) {
    const double angle = 2 * std::numbers::pi * k / points, r = radius * (1 + 0.2 * std::sin(waves * angle));
    curve.push_back({x + r * std::cos(angle), y + r * std::sin(angle)});
  }
  return curve;
}

// Curves of all sizes in a square, some of them far smaller than it.
Curves scattered(std::uint64_t seed, int count, int points) {
  oracle::Random random(seed);
  Curves curves;
  for (int k = 0; k < count; ++k) {
    const double radius = random.log_uniform(0.01, 1);
    curves.push_back(wavy_curve(random.uniform(0, 4), random.uniform(0, 4), radius, points, k % 7));
  }
  return curves;
}

std::vector<CurveView> views_of(const Curves& curves) {
  std::vector<CurveView> views;
  for (const auto& points : curves) views.push_back({points});
  return views;
}

OverlapOptions all_measures() {
  OverlapOptions options;
  options.measures = {all_overlap_measures.begin(), all_overlap_measures.end()};
  return options;
}

std::vector<double> numbers_of(const Overlay& found) {
  const Areas& area = found.areas;
  return {area.intersection,
          area.union_,
          area.c1_minus_c2,
          area.c2_minus_c1,
          area.symmetric_difference,
          static_cast<double>(found.nodes.crossings()),
          static_cast<double>(found.nodes.touches()),
          static_cast<double>(found.nodes.shared_arcs())};
}

// Where the pair has an entry, equal bits; else what follows from both areas, to a rounding.
void expect_pair(const OverlapMatrix& matrix, const std::vector<std::vector<double>>& dense,
                 const std::vector<std::vector<double>>& bounds, std::size_t row, std::size_t column,
                 const Overlay& found) {
  const std::vector<double> expected = numbers_of(found);
  bool has_entry = false;
  for (std::size_t k = matrix.begin[row]; k < matrix.begin[row + 1]; ++k)
    has_entry = has_entry || matrix.column[k] == column;
  EXPECT_EQ(has_entry, found.nodes.size() > 0 || found.areas.intersection > 0) << row << ' ' << column;
  for (std::size_t m = 0; m < expected.size(); ++m) {
    const std::size_t at = row * matrix.columns + column;
    if (has_entry) {
      EXPECT_EQ(dense[m][at], expected[m]) << row << ' ' << column << ' ' << name(all_overlap_measures[m]);
    } else {
      EXPECT_NEAR(dense[m][at], expected[m], bounds[m][at]) << row << ' ' << column << ' ' << m;
    }
  }
}

TEST(OverlapMatrix, TwoSetsAgreeWithOverlaysOfAllPairs) {
  const Curves first = scattered(1, 40, 60), second = scattered(2, 50, 45);
  const OverlapMatrix matrix = overlap_matrix(views_of(first), views_of(second), all_measures());
  std::vector<std::vector<double>> dense, bounds;
  for (std::size_t m = 0; m < matrix.numbers.size(); ++m) {
    dense.push_back(matrix.dense(m));
    bounds.push_back(matrix.dense_bounds(m));
  }
  for (std::size_t i = 0; i < first.size(); ++i) {
    for (std::size_t k = 0; k < second.size(); ++k) {
      expect_pair(matrix, dense, bounds, i, k, overlay(ClosedCurve::borrow(first[i]), ClosedCurve::borrow(second[k])));
    }
  }
  EXPECT_GT(matrix.column.size(), 50u);
  EXPECT_LT(matrix.pairs, first.size() * second.size() / 2);
  EXPECT_GE(matrix.pairs, matrix.column.size());
}

TEST(OverlapMatrix, OneSetHasBothSidesOfTheDiagonal) {
  const Curves curves = scattered(3, 40, 50);
  const OverlapMatrix matrix = overlap_matrix(views_of(curves), all_measures());
  const std::size_t n = curves.size();
  std::vector<std::vector<double>> dense;
  for (std::size_t m = 0; m < matrix.numbers.size(); ++m) dense.push_back(matrix.dense(m));
  for (std::size_t i = 0; i < n; ++i) {
    const auto row = [&](std::size_t k) {
      return matrix.column.begin() + static_cast<std::ptrdiff_t>(matrix.begin[k]);
    };
    EXPECT_TRUE(std::is_sorted(row(i), row(i + 1)));
    for (std::size_t k = i; k < n; ++k) {
      const std::vector<double> expected =
          numbers_of(overlay(ClosedCurve::borrow(curves[i]), ClosedCurve::borrow(curves[k])));
      const bool apart = expected[0] == 0 && expected[5] + expected[6] + expected[7] == 0;
      for (std::size_t m = 0; m < expected.size(); ++m) {
        const std::size_t across = m == 2 ? 3 : m == 3 ? 2 : m;
        if (!apart) {
          EXPECT_EQ(dense[m][i * n + k], expected[m]);
        }
        EXPECT_EQ(dense[m][i * n + k], dense[across][k * n + i]);
      }
    }
    EXPECT_EQ(dense[7][i * n + i], 1);  // a curve shares itself
    EXPECT_EQ(dense[2][i * n + i], 0);
  }
}

// A difference alone needs the other one for the pairs across the diagonal.
TEST(OverlapMatrix, OneMeasureIsTheSameAsAmongAll) {
  const Curves curves = scattered(4, 30, 40);
  const OverlapMatrix all = overlap_matrix(views_of(curves), all_measures());
  for (std::size_t m = 0; m < all_overlap_measures.size(); ++m) {
    OverlapOptions one;
    one.measures = {all_overlap_measures[m]};
    const OverlapMatrix matrix = overlap_matrix(views_of(curves), one);
    ASSERT_EQ(matrix.numbers.size(), 1u);
    EXPECT_EQ(matrix.numbers[0].values, all.numbers[m].values);
    EXPECT_EQ(matrix.numbers[0].bounds, all.numbers[m].bounds);
    EXPECT_EQ(matrix.dense(0), all.dense(m));
  }
}

TEST(OverlapMatrix, SameBitsForAnyThreads) {
  Curves curves = scattered(5, 200, 30);
  curves.push_back(wavy_curve(2, 2, 3, 200000, 40));  // a huge one is parallel inside
  curves.push_back(wavy_curve(2.1, 2, 3, 150000, 30));
  const OverlapMatrix one = detail::with_threads(1, [&] { return overlap_matrix(views_of(curves), all_measures()); });
  for (const int threads : {2, 7}) {
    const OverlapMatrix other =
        detail::with_threads(threads, [&] { return overlap_matrix(views_of(curves), all_measures()); });
    EXPECT_EQ(one.begin, other.begin);
    EXPECT_EQ(one.column, other.column);
    for (std::size_t m = 0; m < one.numbers.size(); ++m) EXPECT_EQ(one.numbers[m].values, other.numbers[m].values);
  }
}

TEST(OverlapMatrix, CurvesThatTouchOrLieInsideHaveEntries) {
  const Curves squares{{{0, 0}, {4, 0}, {4, 4}, {0, 4}},
                       {{1, 1}, {2, 1}, {2, 2}, {1, 2}},
                       {{4, 0}, {5, 0}, {5, 4}, {4, 4}},
                       {{5, 4}, {6, 4}, {6, 5}, {5, 5}},
                       {{7, 0}, {8, 0}, {8, 1}}};
  const OverlapMatrix matrix = overlap_matrix(views_of(squares), all_measures());
  EXPECT_EQ(matrix.begin, (std::vector<std::size_t>{0, 3, 5, 8, 10, 11}));
  EXPECT_EQ(matrix.dense(0)[1], 1);          // the small one
  EXPECT_EQ(matrix.dense(7)[2], 1);          // an edge
  EXPECT_EQ(matrix.dense(6)[2 * 5 + 3], 1);  // a corner
  EXPECT_EQ(matrix.dense(1)[4], 16.5);       // apart
  EXPECT_EQ(matrix.dense(2)[4 * 5], 0.5);
  EXPECT_EQ(matrix.areas[0], (std::vector<double>{16, 1, 4, 1, 0.5}));
}

TEST(OverlapMatrix, CurvesThatCannotBeUsedAreNamedOrFail) {
  const double nan = std::nan("");
  Curves curves = scattered(6, 6, 20);
  curves[2] = {{0, 0}, {1, 1}, {1, 0}, {0, 1}};
  curves[4] = {{0, 0}, {nan, 1}, {1, 0}};
  curves[5] = {{0, 0}, {1, 0}};
  const std::vector<CurveView> views = views_of(curves);
  try {
    (void)overlap_matrix(views);
    FAIL();
  } catch (const DataError& error) {
    EXPECT_STREQ(error.what(), "curve 2: is not simple: segments 0 and 2 meet");
  }
  OverlapOptions options = all_measures();
  options.keep_going = true;
  const OverlapMatrix matrix = overlap_matrix(views, options);
  ASSERT_EQ(matrix.failures.size(), 3u);
  EXPECT_EQ(matrix.failures[1].row, 4u);
  EXPECT_EQ(matrix.failures[1].column, OverlapMatrix::none);
  EXPECT_TRUE(std::isnan(matrix.dense(0)[2]) && std::isnan(matrix.dense(5)[5 * 6]) && std::isnan(matrix.areas[1][4]));
  EXPECT_FALSE(std::isnan(matrix.dense(0)[1]));
  CurveView open = views[0];
  open.closed = false;
  EXPECT_THROW((void)overlap_matrix(std::vector<CurveView>{open}), UsageError);
}

TEST(OverlapMatrix, EmptySetsAndHugeCoordinates) {
  const Curves curves = scattered(7, 3, 20);
  EXPECT_TRUE(overlap_matrix(std::vector<CurveView>{}, views_of(curves)).dense(0).empty());
  EXPECT_EQ(overlap_matrix(std::vector<CurveView>{}).begin, std::vector<std::size_t>{0});
  const double big = 0x1p600;
  const Curves huge{{{0, 0}, {big, 0}, {big, big}}, {{-big, 0}, {big, 0}, {0, big}}};
  EXPECT_THROW((void)overlap_matrix(views_of(huge)), DataError);  // areas beyond the range of double
  const double far = 0x1p400;
  const Curves large{{{-far, -far}, {far, -far}, {far, far}, {-far, far}}, {{0, 0}, {far, 0}, {far, far}, {0, far}}};
  EXPECT_EQ(overlap_matrix(views_of(large)).dense(0)[1], 0x1p800);
}

TEST(OverlapMatrix, IsCancelledByProgressAndByScope) {
  const Curves curves = scattered(8, 400, 200);
  OverlapOptions options;
  std::atomic<int> calls{0};
  options.progress = [&](double fraction) {
    EXPECT_TRUE(fraction > 0 && fraction <= 1);
    return ++calls < 1;
  };
  EXPECT_THROW((void)overlap_matrix(views_of(curves), options), Cancelled);
  EXPECT_EQ(calls, 1);
  const std::atomic<bool> flag{true};
  const CancellationScope scope(flag);
  EXPECT_THROW((void)overlap_matrix(views_of(curves)), Cancelled);
}

}  // namespace
}  // namespace lober
