// Areas by the interior method against exact rational arithmetic, and against the overlay.
//
// LOBER_INTERIOR_PAIRS  how many pairs as generated, over all families (default 5000)
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <mutex>
#include <sstream>
#include <string>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "lober/overlay/interior.hpp"
#include "lober/overlay/overlay.hpp"
#include "tests/oracle/exact_curve.hpp"
#include "tests/oracle/exact_overlay.hpp"
#include "tests/oracle/families.hpp"
#include "tests/oracle/judge.hpp"
#include "tests/shapes.hpp"
#include "tests/views.hpp"

namespace lober::detail {
namespace {

using oracle::Polygon;
using oracle::Rational;
using oracle::rearranged;
using test::box;
using test::circle;
using test::wavy_circle;

constexpr std::array members{&Areas::c1,          &Areas::c2,          &Areas::intersection,        &Areas::union_,
                             &Areas::c1_minus_c2, &Areas::c2_minus_c1, &Areas::symmetric_difference};

std::array<Rational, 7> exact_areas(const oracle::ExactOverlay& exact) {
  const auto& areas = exact.areas;
  return {exact.area1,
          exact.area2,
          areas[oracle::intersection],
          areas[oracle::union_],
          areas[oracle::c1_minus_c2],
          areas[oracle::c2_minus_c1],
          areas[oracle::c1_minus_c2] + areas[oracle::c2_minus_c1]};
}

Rational box_area(const oracle::CurvePair& pair) {
  Point low = pair.first.front(), high = low;
  for (const Polygon* polygon : {&pair.first, &pair.second}) {
    for (const Point& point : *polygon) {
      low = {std::min(low.x, point.x), std::min(low.y, point.y)};
      high = {std::max(high.x, point.x), std::max(high.y, point.y)};
    }
  }
  return (Rational(high.x) - Rational(low.x)) * (Rational(high.y) - Rational(low.y));
}

// The faults in the areas of a pair; empty if there are none.
std::string complaints(const oracle::CurvePair& pair) {
  std::ostringstream text;
  try {
    const std::array<Rational, 7> exact = exact_areas(oracle::exact_overlay(pair.first, pair.second));
    const InteriorAreas found = interior_areas(CurveView{pair.first}, CurveView{pair.second});
    const Areas other = overlay(CurveView{pair.first}, CurveView{pair.second}).areas;
    const Rational large = box_area(pair) * Rational(oracle::large_area);
    const Rational slack = large * Rational(oracle::large_error) + Rational(oracle::area_underflow);
    for (std::size_t k = 0; k < members.size(); ++k) {
      const double value = found.areas.*members[k];
      if (!std::isfinite(value)) {
        text << "area " << k << " is " << value << "\n";
        continue;
      }
      const Rational error = abs(Rational(value) - exact[k]);
      const Rational allowed =
          exact[k] > large ? Rational(exact[k] * Rational(oracle::large_error) + Rational(oracle::area_underflow))
                           : slack;
      if (error > allowed) text << "area " << k << ": " << value << ", exactly " << exact[k].get_d() << "\n";
      if (error > Rational(found.rounding.*members[k])) {
        text << "area " << k << ": error " << error.get_d() << ", bound " << found.rounding.*members[k] << "\n";
      }
      if (abs(Rational(value) - Rational(other.*members[k])) > 2 * allowed) {
        text << "area " << k << ": " << value << ", by the overlay " << other.*members[k] << "\n";
      }
    }
  } catch (const std::exception& error) {
    text << "thrown: " << error.what() << "\n";
  }
  return text.str();
}

class InteriorOfFamilies : public testing::TestWithParam<oracle::Family> {};

TEST_P(InteriorOfFamilies, AgreesWithTheExactAreas) {
  const char* text = std::getenv("LOBER_INTERIOR_PAIRS");
  const std::uint64_t wanted = text != nullptr ? std::strtoull(text, nullptr, 10) : 5000;
  const std::uint64_t count = (wanted + oracle::families().size() - 1) / oracle::families().size();
  std::mutex mutex;
  int written = 0;
  const auto check = [&](const oracle::CurvePair& pair) {
    const std::string wrong = complaints(pair);
    if (wrong.empty()) return;
    const std::lock_guard lock(mutex);
    if (++written <= 3) ADD_FAILURE() << pair.family << " " << pair.seed << "\n" << wrong;
  };
  for_each_block(count, 1, [&](std::size_t seed, std::size_t) {
    const oracle::CurvePair pair = oracle::make_curve_pair(GetParam(), seed);
    check(pair);
    if (seed % 4 == 1) check(rearranged(pair));
    if (seed % 4 == 3) {
      const oracle::CurvePair moved = oracle::transformed(pair);
      if (oracle::is_simple(moved.first) && oracle::is_simple(moved.second)) check(moved);
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Families, InteriorOfFamilies,
                         testing::ValuesIn(oracle::families().begin(), oracle::families().end()),
                         [](const auto& family) { return std::string(family.param.name); });

std::pair<double, double> differences(const std::vector<Point>& c1, const std::vector<Point>& c2,
                                      const InteriorOptions& options = {}) {
  const Areas areas = interior_areas(CurveView{c1}, CurveView{c2}, options).areas;
  return {areas.c1_minus_c2, areas.c2_minus_c1};
}

// Cases that Lober 1.8 gets wrong.
TEST(InteriorAreasOf, SharedSides) {
  using Pair = std::pair<double, double>;
  EXPECT_EQ(differences(box(0, 0, 1, 1), box(0, 0, 2, 1)), Pair(0, 1));
  EXPECT_EQ(differences(box(0, 0, 1, 1), box(0.5, 0, 1.5, 1)), Pair(0.5, 0.5));
  EXPECT_EQ(differences(box(0, 0, 1, 1), box(1, 0.25, 2, 0.75)), Pair(1, 0.5));
  EXPECT_EQ(differences(box(0, 2, 6, 4), box(2, 0, 4, 6)), Pair(8, 8));
  EXPECT_EQ(differences(box(0, 0, 2, 2), {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}), Pair(0, 0));
  // The shared side outside of both: the integrals along it cancel.
  EXPECT_EQ(differences(box(0, 0, 1, 1), box(1, 0, 2, 1)), Pair(1, 1));
}

TEST(InteriorAreasOf, CurvesOfOppositeOrientation) {
  const std::vector<Point> square = box(0, 0, 2, 2), other = box(1, 1, 4, 4);
  const std::vector<Point> backwards(other.rbegin(), other.rend());
  for (const auto& second : {other, backwards}) {
    const InteriorAreas found = interior_areas(CurveView{square}, CurveView{second});
    EXPECT_EQ(found.q1, 11);
    EXPECT_EQ(found.q2, 12);
    EXPECT_EQ(found.q3, 1);
    EXPECT_EQ(found.delta, 0);
    EXPECT_EQ(found.areas.symmetric_difference, 11);
  }
  EXPECT_EQ(interior_areas(CurveView{square}, CurveView{backwards}).orientation2, Orientation::clockwise);
}

TEST(InteriorAreasOf, CurvesThatAreNotSimpleAreRefused) {
  const std::vector<Point> bow{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, square = box(0, 0, 1, 1);
  EXPECT_THROW((void)interior_areas(CurveView{square}, CurveView{bow}), NotSimpleError);
  const std::vector<Point> infinite{{0, 0}, {INFINITY, 1}, {1, 0}};
  EXPECT_THROW((void)interior_areas(CurveView{square}, CurveView{infinite}), DataError);
}

TEST(InteriorAreasOf, SegmentsThatAreNotSplitConvergeWithDensifying) {
  const std::vector<Point> c1 = circle(100, {0, 0}, 1), c2 = circle(90, {1, 0.3}, 1);
  const double exact = differences(c1, c2).first;
  const auto error = [&](int passes, int points) {
    InteriorOptions options{.method = InteriorMethod::ends};
    options.passes = passes;
    options.points = points;
    return std::fabs(differences(c1, c2, options).first - exact);
  };
  const double plain = error(0, 0);
  EXPECT_GT(plain, 1e-5);  // it is an approximation
  EXPECT_LT(plain, 3e-2);
  EXPECT_LT(error(1, 10), plain / 3);
  EXPECT_LT(error(3, 10), plain / 300);
  EXPECT_LT(error(5, 100), 1e-10);
  EXPECT_EQ(error(0, 10), plain);
  EXPECT_EQ(error(10, 0), plain);
  EXPECT_LT(error(1000, 1), 1e-14);  // ends where neighbours are one point
}

TEST(InteriorAreasOf, SegmentsThatAreNotSplitMissWhatCrossesTwice) {
  // Both ends of the horizontal sides of one bar lie outside the other: the rule of -DENS 0 sees no crossing at all.
  const std::vector<Point> bar1 = box(0, 2, 6, 4), bar2 = box(2, 0, 4, 6);
  const InteriorAreas found =
      interior_areas(CurveView{bar1}, CurveView{bar2}, {.method = InteriorMethod::ends, .passes = 3, .points = 10});
  EXPECT_EQ(found.statistics.points_inserted, 0U);
  EXPECT_EQ(found.areas.c1_minus_c2, 12);  // as Lober 1.8 prints
  EXPECT_EQ(found.delta, 0);               // and says that it has no error
}

TEST(InteriorAreasOf, AnyNumberOfThreadsAreTheSameBits) {
  const std::vector<Point> c1 = wavy_circle(60000, 0.1, 40), c2 = wavy_circle(50000, -0.1, 40, 0, {0.05, 0.02}, 1.01);
  for (const InteriorMethod method : {InteriorMethod::split, InteriorMethod::ends}) {
    const auto run = [&](int threads) {
      return with_threads(threads, [&] {
        return interior_areas(CurveView{c1}, CurveView{c2}, {.method = method, .passes = 3, .points = 7});
      });
    };
    const InteriorAreas one = run(1);
    EXPECT_GT(one.nodes.crossings(), 50U);
    for (const int threads : {2, 4}) {
      const InteriorAreas many = run(threads);
      for (const auto member : members) {
        EXPECT_EQ(one.areas.*member, many.areas.*member);
        EXPECT_EQ(one.rounding.*member, many.rounding.*member);
      }
      EXPECT_EQ(one.q1, many.q1);
      EXPECT_EQ(one.delta, many.delta);
      EXPECT_EQ(one.statistics.queries, many.statistics.queries);
    }
  }
}

TEST(InteriorAreasOf, ManyCrossingsAndManyPointsAgreeWithTheOverlay) {
  const std::vector<Point> c1 = wavy_circle(200000, 0.1, 40), c2 = wavy_circle(300000, -0.1, 40, 0, {0, 0}, 1.01);
  const InteriorAreas found = interior_areas(CurveView{c1}, CurveView{c2});
  const Areas other = overlay(CurveView{c1}, CurveView{c2}).areas;
  for (const auto member : members) {
    EXPECT_NEAR(found.areas.*member, other.*member, 1e-15 * other.*member);
  }
  EXPECT_GT(found.rounding.union_, 0);
  EXPECT_LT(found.rounding.union_, 1e-15);
}

}  // namespace
}  // namespace lober::detail
