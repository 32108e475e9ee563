// How a curve runs, where the rounding of its area would not tell; and what happens to curves that have no orientation.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/geometry/index/orientation.hpp"
#include "lober/overlay/interior.hpp"
#include "lober/overlay/overlay.hpp"
#include "tests/oracle/crossing_polygons.hpp"
#include "tests/oracle/exact_curve.hpp"
#include "tests/oracle/families.hpp"
#include "tests/oracle/random.hpp"
#include "tests/shapes.hpp"
#include "tests/views.hpp"

namespace lober::test {
using namespace lober::detail;
namespace {

Orientation of(const Points& points) {
  return orientation(IndexedCurve(CurveView{points}));
}

// Both ways round, from every vertex.
void expect_counter_clockwise(const Points& points) {
  Points turned = points;
  for (std::size_t k = 0; k < points.size(); ++k) {
    EXPECT_EQ(of(turned), Orientation::counter_clockwise) << "from vertex " << k;
    EXPECT_EQ(of(Points(turned.rbegin(), turned.rend())), Orientation::clockwise) << "from vertex " << k;
    std::rotate(turned.begin(), turned.begin() + 1, turned.end());
  }
}

TEST(Orientation, IsExactForAreasThatAreLostToRoundingAndUnderflow) {
  const double a = 8.5159196800163014e-109;
  expect_counter_clockwise({{0, a}, {a, 0}, {a * a, a}});  // found by random overlays: its area is 3e-325
  expect_counter_clockwise({{0, 0}, {5e-324, 0}, {0, 5e-324}});
  expect_counter_clockwise({{0, 0}, {1e200, 1e200}, {1e200, std::nextafter(1e200, 2e200)}});
  expect_counter_clockwise({{0, 0}, {1, 0}, {1, 5e-324}});
  expect_counter_clockwise({{-1e300, -1e300}, {1e300, -1e300}, {1e300, 1e300}, {1e-300, 1e-300}, {0, 1e-300}});
}

TEST(Orientation, LooksPastRepeatedAndCollinearVertices) {
  const double thin = 1e-200;
  expect_counter_clockwise({{0, 0}, {0, 0}, {1, 0}, {2, 0}, {2, 0}, {2, 0}, {2, thin}, {2, thin}, {1, thin}});
  expect_counter_clockwise({{0, 0}, {2, 0}, {2, thin}, {2, 2 * thin}, {2, 3 * thin}, {0, 3 * thin}});
}

TEST(Orientation, OfACurveThatTurnsBackThereIsNone) {
  EXPECT_EQ(of({{0, 0}, {1, 0}, {2, 0}}), Orientation::degenerate);
  EXPECT_EQ(of({{0, 0}, {2, 2}, {2, 2}}), Orientation::degenerate);
}

// A curve that crosses itself runs as the larger part of it does.
TEST(Orientation, OfACurveThatCrossesItselfIsTheSignOfItsArea) {
  EXPECT_EQ(of({{0, 0}, {4, 4}, {4, 3}, {-8, 16}}), Orientation::counter_clockwise);
  EXPECT_EQ(of({{-8, 16}, {4, 3}, {4, 4}, {0, 0}}), Orientation::clockwise);
}

class OrientationOfFamilies : public ::testing::TestWithParam<oracle::Family> {};

TEST_P(OrientationOfFamilies, IsTheExactOne) {
  std::size_t clockwise = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const oracle::CurvePair pair = oracle::make_curve_pair(GetParam(), seed);
    for (const oracle::Polygon* polygon : {&pair.first, &pair.second}) {
      const bool reversed = oracle::exact_curve(*polygon, oracle::common_exponent(*polygon, {})).reversed;
      EXPECT_EQ(of(*polygon), reversed ? Orientation::clockwise : Orientation::counter_clockwise) << "seed " << seed;
      clockwise += reversed;
    }
  }
  EXPECT_GT(clockwise, 100U);
  EXPECT_LT(clockwise, 300U);
}

INSTANTIATE_TEST_SUITE_P(Families, OrientationOfFamilies,
                         ::testing::ValuesIn(oracle::families().begin(), oracle::families().end()),
                         [](const auto& member) { return std::string(member.param.name); });

// Taken for simple, such curves have no right answer; but nothing may be read or written where it should not.
TEST(Orientation, CurvesThatAreNotSimpleDoNoHarmUnchecked) {
  OverlayOptions unchecked;
  unchecked.check_simple = false;
  InteriorOptions unchecked_interior;
  unchecked_interior.check_simple = false;
  std::size_t answered = 0, refused = 0;
  for (const oracle::CrossingFamily& family : oracle::crossing_families()) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      oracle::Random random(seed);
      const oracle::PolygonPair pair = family.make(random);
      try {
        const Overlay result = overlay(CurveView{pair.first}, CurveView{pair.second}, unchecked);
        (void)interior_areas(CurveView{pair.first}, CurveView{pair.second}, unchecked_interior);
        ++answered;
        EXPECT_LT(result.pieces(Pairing::union_).size(), 1000U);
      } catch (const DataError&) {
        ++refused;
      }
    }
  }
  EXPECT_GT(answered, 0U);
  EXPECT_EQ(answered + refused, 60 * oracle::crossing_families().size());
}

}  // namespace
}  // namespace lober::test
