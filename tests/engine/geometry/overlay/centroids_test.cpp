// Centroids of pieces: of any size, at any scale, with any number of points.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "kernels/moments.hpp"
#include "lober/overlay/overlay.hpp"
#include "tests/shapes.hpp"
#include "tests/views.hpp"

namespace lober::test {
using namespace lober::detail;
namespace {

// By the definition, from the outline as it is written.
Point reference(const Overlay& result, Pairing pairing, std::size_t piece) {
  const std::vector<Points> polygons = outline(result, pairing, piece);
  const Point origin = polygons[0][0];
  Moments sum;
  for (const Points& polygon : polygons) {
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      sum += moments_of_segment(polygon[(k + polygon.size() - 1) % polygon.size()], polygon[k], origin, 1);
    }
  }
  const DD below = DD{3, 0} * sum.area;
  return {origin.x + (sum.x / below).hi, origin.y + (sum.y / below).hi};
}

std::size_t expect_as_by_definition(const Overlay& result) {
  std::size_t compared = 0;
  for (const Pairing pairing : all_pairings) {
    const std::vector<Point> found = centroids(result, pairing);
    EXPECT_EQ(found.size(), result.pieces(pairing).size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      // The same to the last bit but where a coordinate is zero beside the size of the scene, which is 1.
      const Point expected = reference(result, pairing, k);
      EXPECT_NEAR(found[k].x, expected.x, 1e-22) << name(pairing) << " " << k;
      EXPECT_NEAR(found[k].y, expected.y, 1e-22) << name(pairing) << " " << k;
      ++compared;
    }
  }
  return compared;
}

// Long boundaries are summed up without being written out.
TEST(Centroids, OfLongBoundariesAreThoseOfTheirOutlines) {
  Points first = wavy_circle(40001, 0.05, 7), second = wavy_circle(30000, 0.05, 5, 0.1);
  for (const bool turned : {false, true}) {
    if (turned) std::reverse(second.begin(), second.end());
    EXPECT_GT(expect_as_by_definition(overlay(CurveView{first}, CurveView{second})), 10U);
  }
  std::rotate(first.begin(), first.begin() + 777, first.end());
  EXPECT_GT(expect_as_by_definition(overlay(CurveView{second}, CurveView{first})), 10U);
}

TEST(Centroids, OfPiecesWithHolesAndWholeCurves) {
  Points outer = wavy_circle(20000, 0.05, 7), inner = wavy_circle(9000, 0.01, 3);
  for (Point& p : inner) p = {0.3 * p.x + 0.2, 0.3 * p.y};
  EXPECT_EQ(expect_as_by_definition(overlay(CurveView{outer}, CurveView{inner})), 3U);
  std::reverse(outer.begin(), outer.end());
  EXPECT_EQ(expect_as_by_definition(overlay(CurveView{inner}, CurveView{outer})), 3U);
}

TEST(Centroids, OfBoundariesWithManyNodes) {
  EXPECT_GT(
      expect_as_by_definition(overlay(CurveView{wavy_circle(9000, 0.05, 401)}, CurveView{wavy_circle(9000, 0.05, 3)})),
      700U);
}

TEST(Centroids, AreTheSameForAnyNumberOfThreads) {
  const Points first = wavy_circle(40000, 0.05, 7), second = wavy_circle(30000, 0.05, 5, 0.1);
  const Overlay result = overlay(CurveView{first}, CurveView{second});
  const auto with = [&](int threads) {
    return with_threads(threads, [&] { return centroids(result, Pairing::union_); });
  };
  EXPECT_EQ(with(1), with(2));
  EXPECT_EQ(with(1), with(7));
}

// A power of two changes no digit.
TEST(Centroids, DoNotDependOnTheScale) {
  const Points first = wavy_circle(50, 0.2, 3), second = wavy_circle(40, 0.2, 2, 0.3);
  const Overlay plain = overlay(CurveView{first}, CurveView{second});
  for (const int exponent : {-1000, -500, -365, -299, -100, 100, 299, 365, 450, 509}) {
    Points first_scaled = first, second_scaled = second;
    for (Points* points : {&first_scaled, &second_scaled}) {
      for (Point& p : *points) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
    }
    const Overlay scaled = overlay(CurveView{first_scaled}, CurveView{second_scaled});
    for (const Pairing pairing : all_pairings) {
      const std::vector<Point> expected = centroids(plain, pairing), found = centroids(scaled, pairing);
      ASSERT_EQ(found.size(), expected.size()) << exponent;
      for (std::size_t k = 0; k < found.size(); ++k) {
        EXPECT_EQ(std::ldexp(found[k].x, -exponent), expected[k].x) << exponent;
        EXPECT_EQ(std::ldexp(found[k].y, -exponent), expected[k].y) << exponent;
      }
    }
    const Areas lost = discretisation_error(scaled);
    EXPECT_TRUE(std::isfinite(lost.union_) && std::isfinite(lost.c1_minus_c2)) << exponent;
  }
}

// A lobe that is small beside its scene, where third powers underflow.
TEST(Centroids, OfTinyPiecesInAnOrdinaryScene) {
  const double size = 1e-120;
  const Points first{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 8 * size}};
  const Points second{{-1, -1}, {8 * size, -2 * size}, {-4 * size, 4 * size}, {-1, 0.5}};
  const Overlay result = overlay(CurveView{first}, CurveView{second});
  const std::vector<Point> found = centroids(result, Pairing::intersection);
  ASSERT_EQ(found.size(), 1U);
  // The triangle (0, 0), (4, 0), (0, 2) times the size.
  EXPECT_NEAR(found[0].x / size, 4.0 / 3, 1e-15);
  EXPECT_NEAR(found[0].y / size, 2.0 / 3, 1e-15);
}

}  // namespace
}  // namespace lober::test
