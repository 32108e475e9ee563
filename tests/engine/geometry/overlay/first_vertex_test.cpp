// Walks round faces where they pass the first vertex of a curve, either way round.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "lober/overlay/overlay.hpp"
#include "tests/shapes.hpp"
#include "tests/views.hpp"

namespace lober::test {
using namespace lober::detail;
namespace {

// A curve with lobes; `from` is its first vertex.
Points lobed_curve(int lobes, double phase, int from, bool clockwise) {
  Points points;
  for (int k = 0; k < 48; ++k) {
    const double angle = 2 * std::numbers::pi * k / 48, radius = 1 + 0.2 * std::sin(lobes * angle + phase);
    points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  std::rotate(points.begin(), points.begin() + from, points.end());
  return clockwise ? reversed(std::move(points)) : points;
}

double area_inside(const std::vector<Points>& polygons) {
  double area = 0;
  for (const Points& polygon : polygons) area += signed_area(CurveView{polygon});
  return area;
}

std::vector<double> in_ascending_order(std::span<const double> areas) {
  std::vector<double> result(areas.begin(), areas.end());
  std::sort(result.begin(), result.end());
  return result;
}

class FirstVertex : public testing::TestWithParam<int> {};

TEST_P(FirstVertex, AnyOfEitherCurveGivesTheSamePieces) {
  const Points base1 = lobed_curve(5, 0.1, 0, false), base2 = lobed_curve(7, 0.7, 0, false);
  const Overlay expected = overlay(CurveView{base1}, CurveView{base2});
  ASSERT_GT(expected.nodes.crossings(), 6U);
  const bool clockwise1 = GetParam() % 2 == 1, clockwise2 = GetParam() / 2 == 1;
  for (int from1 = 0; from1 < 48; ++from1) {
    for (const int from2 : {0, 5, 11, 23, 24, 31, 40, 47}) {
      const Points first = lobed_curve(5, 0.1, from1, clockwise1), second = lobed_curve(7, 0.7, from2, clockwise2);
      const Overlay result = overlay(CurveView{first}, CurveView{second});
      ASSERT_EQ(result.nodes.crossings(), expected.nodes.crossings());
      EXPECT_EQ(result.class_count, expected.class_count);
      for (const Pairing pairing : all_pairings) {
        const Pieces pieces = result.pieces(pairing);
        const std::vector<double> areas = in_ascending_order(pieces.areas()),
                                  as_expected = in_ascending_order(expected.pieces(pairing).areas());
        ASSERT_EQ(areas.size(), as_expected.size()) << name(pairing) << ' ' << from1 << ' ' << from2;
        for (std::size_t k = 0; k < areas.size(); ++k) EXPECT_NEAR(areas[k], as_expected[k], 1e-15);
        for (std::size_t piece = 0; piece < pieces.size(); ++piece) {
          EXPECT_NEAR(area_inside(outline(result, pairing, piece)), pieces.areas()[piece], 1e-14);
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Orientations, FirstVertex, testing::Range(0, 4));

}  // namespace
}  // namespace lober::test
