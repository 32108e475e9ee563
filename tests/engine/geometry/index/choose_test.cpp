// The tree nearly always; the grid where long slanted segments make boxes useless.
#include <gtest/gtest.h>

#include "engine/geometry/index/index.hpp"
#include "tests/engine/geometry/index/scenes.hpp"

namespace lober::test {
using namespace lober::detail;
namespace {

IndexKind choice(const Curve& first, const Curve& second) {
  return choose_index(IndexedCurve(first), IndexedCurve(second));
}

// A circle with `waves` waves.
Curve flower(std::size_t size, double waves, double phase) {
  Curve curve = scene::circle(size, {0, 0}, 1);
  for (Point& point : curve.points) {
    const double radius = 1 + 0.2 * std::sin(waves * std::atan2(point.y, point.x) + phase);
    point = {point.x * radius, point.y * radius};
  }
  return curve;
}

TEST(ChooseIndex, TakesTheTreeForCurvesOfShortSegments) {
  EXPECT_EQ(choice(scene::circle(100000, {0, 0}, 1), scene::circle(100000, {0.7, 0.1}, 1)), IndexKind::tree);
  EXPECT_EQ(choice(scene::circle(100000, {0, 0}, 1), scene::circle(100000, {1e-7, 0}, 1)), IndexKind::tree);
  EXPECT_EQ(choice(scene::circle(100000, {0, 0}, 1), scene::circle(1000, {5, 5}, 1)), IndexKind::tree);
  EXPECT_EQ(choice(flower(100000, 500, 0), flower(100000, 500, 1)), IndexKind::tree);
}

TEST(ChooseIndex, TakesTheTreeForSmallCurves) {
  Random random(seed());
  for (const SceneKind& kind : scene_kinds()) {
    const Scene made = kind.make(random, 50);
    EXPECT_EQ(choice(made.first, made.second), IndexKind::tree) << kind.name;
  }
}

// A plain grid would have nearly all points in one cell.
TEST(ChooseIndex, TakesTheTreeForGeometricDensity) {
  Random random(seed());
  const Scene made = scene::geometric(random, 100000);
  EXPECT_EQ(choice(made.first, made.second), IndexKind::tree);
}

TEST(ChooseIndex, TakesTheGridForLongSlantedSegments) {
  const Curve comb = scene::needles(10000, 0.8, {0, 0}), fine = scene::circle(100000, {0.3, 0.2}, 0.5);
  EXPECT_EQ(choice(comb, fine), IndexKind::grid);
  EXPECT_EQ(choice(fine, comb), IndexKind::grid);
  EXPECT_EQ(choice(comb, scene::needles(10000, 0.8, {0.3, 0.2})), IndexKind::grid);
}

}  // namespace
}  // namespace lober::test
