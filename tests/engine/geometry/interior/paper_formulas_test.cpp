// Formulas of Naik, Lekien & Ross (2017) as printed, where they do not give what they should: the numbers of
// docs/errata.md.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "lober/overlay/interior.hpp"
#include "lober/overlay/regions.hpp"
#include "tests/shapes.hpp"
#include "tests/views.hpp"

namespace lober::detail {
namespace {

std::vector<Point> loop(int points) {
  std::vector<Point> curve;
  for (int k = 0; k < points; ++k) {
    const double t = 2 * std::numbers::pi * k / points;
    curve.push_back({std::cos(2 * t) + 0.55 * std::cos(5 * t), std::sin(2 * t) + 0.55 * std::sin(5 * t)});
  }
  return curve;
}

// Q3 of section 4.2, with I = -1 where J >= pi and the coordinates about an origin. A segment has the weight of its
// middle.
double printed_q3(const std::vector<Point>& c1, const std::vector<Point>& c2, Point origin) {
  double sum = 0;
  for (const auto& [own, other] : {std::pair{&c1, &c2}, {&c2, &c1}}) {
    const IndexedCurve indexed{CurveView{*other}};
    for (std::size_t k = 0; k < own->size(); ++k) {
      const Point a = (*own)[k], b = (*own)[k + 1 == own->size() ? 0 : k + 1];
      const double j = interior_function(indexed, {0.5 * (a.x + b.x), 0.5 * (a.y + b.y)}).j;
      const double interior = j >= std::numbers::pi ? -1 : 1;
      const double w = 0.5 * ((a.x - origin.x) * (b.y - origin.y) - (b.x - origin.x) * (a.y - origin.y));
      sum += 0.5 * (1 - interior) * w;
    }
  }
  return sum;
}

TEST(PaperFormulas, DependOnTheOrigin) {
  const std::vector<Point> c1 = loop(1500), c2 = test::circle(1500, {0.9, 0.3}, 0.7);
  EXPECT_NEAR(printed_q3(c1, c2, {0, 0}), 2.154, 2e-3);
  EXPECT_NEAR(printed_q3(c1, c2, {10, 10}), -5.468, 2e-2);
  // The common area of the two is less than the circle, and does not move.
  const double common = regions(ClosedCurve::borrow(c1), ClosedCurve::borrow(c2)).areas(FillRule::nonzero).intersection;
  EXPECT_GT(common, 0);
  EXPECT_LT(common, 0.49 * std::numbers::pi);
  // For two simple curves the formula is right about any origin.
  const std::vector<Point> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  std::vector<Point> fine;
  for (std::size_t side = 0; side < 4; ++side) {
    const Point a = square[side], b = square[(side + 1) % 4];
    for (int k = 0; k < 400; ++k) fine.push_back({a.x + (b.x - a.x) * k / 400, a.y + (b.y - a.y) * k / 400});
  }
  const double right = interior_areas(CurveView{fine}, CurveView{c2}).q3;
  EXPECT_NEAR(printed_q3(fine, c2, {0, 0}), right, 1e-2);
  EXPECT_NEAR(printed_q3(fine, c2, {10, 10}), right, 5e-2);
}

// [A2 \ A1] of two unit squares that overlap by half, with Q1 and with the Q2 that is printed.
TEST(PaperFormulas, TakeQ2ForQ1) {
  const std::vector<Point> first{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, second{{0.5, 0}, {1.5, 0}, {1.5, 1}, {0.5, 1}};
  const InteriorAreas found = interior_areas(CurveView{first}, CurveView{second});
  EXPECT_EQ(0.5 * found.q1 + 0.5 * (found.areas.c2 - found.areas.c1), 0.5);
  EXPECT_EQ(0.5 * found.q2 + 0.5 * (found.areas.c2 - found.areas.c1), 0.75);
  EXPECT_EQ(found.areas.c2_minus_c1, 0.5);
}

}  // namespace
}  // namespace lober::detail
