#include "lober/dynamics/local_manifold.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "lober/base/error.hpp"
#include "lober/dynamics/systems.hpp"
#include "tests/engine/dynamics/test_maps.hpp"

namespace lober {
namespace {

using test::CubicSaddle;
using test::HenonMap;
using test::StandardMap;

// The largest |F(P(s)) - P(lambda s)| at points of our own choice.
double defect(const PlanarMap& map, const LocalManifold& local) {
  double worst = 0;
  for (int k = -500; k <= 500; ++k) {
    const double s = local.reach * (k + 0.37) / 501;
    Point image = local.at(s / local.multiplier);
    map.iterate({&image, 1}, local.steps);
    const Point expected = local.at(s);
    worst = std::max(worst, std::hypot(image.x - expected.x, image.y - expected.y));
  }
  return worst;
}

TEST(LocalManifold, StandardMapReachesFar) {
  for (const double k : {0.1, 1.2, 2.0, 5.0}) {
    const StandardMap map(k);
    for (const ManifoldSide side : {ManifoldSide::unstable, ManifoldSide::stable}) {
      const LocalManifold local = local_manifold(map, {0.01, -0.01}, side);
      const double lambda = 1 + k / 2 + std::sqrt(k + k * k / 4);
      EXPECT_NEAR(local.multiplier, lambda, 1e-12 * lambda);
      EXPECT_GT(local.reach, 3);
      EXPECT_LE(local.defect_across, 1e-14);
      EXPECT_LE(local.defect, lambda * 1e-14);
      EXPECT_LE(defect(map, local), 2 * lambda * 1e-14);
      EXPECT_LT(std::hypot(local.saddle.x, local.saddle.y), 1e-15);
      EXPECT_NEAR(local.tangent.y / local.tangent.x, side == ManifoldSide::unstable ? 1 - 1 / lambda : 1 - lambda,
                  1e-12);
    }
  }
}

TEST(LocalManifold, InverseSaddle) {
  const StandardMap map(5);
  const LocalManifold local = local_manifold(map, {3.1, 0.02}, ManifoldSide::unstable);
  EXPECT_NEAR(local.multiplier, -(3 + std::sqrt(5)) / 2, 1e-12);
  EXPECT_GT(local.reach, 1);
  EXPECT_LE(defect(map, local), 2e-13);
}

TEST(LocalManifold, ClosedForm) {
  for (const double a : {3.0, -3.0, 400.0}) {
    const CubicSaddle map(a, 2);
    const LocalManifold local = local_manifold(map, {1e-3, 1e-3}, ManifoldSide::unstable, {.max_length = 2});
    EXPECT_NEAR(local.multiplier / a, 1, 1e-13);
    for (double s = -local.reach; s <= local.reach; s += local.reach / 16) {
      const Point at = local.at(s);
      EXPECT_NEAR(at.y, map.unstable(at.x), 1e-14) << a << ' ' << s;
      EXPECT_NEAR(at.x, s, 1e-12);
    }
  }
}

TEST(LocalManifold, HenonEscapingBranchDoesNotSpoilTheOther) {
  const HenonMap map(0.5);
  const LocalManifold local = local_manifold(map, {2.2, 2.2}, ManifoldSide::unstable);
  EXPECT_NEAR(local.saddle.x, 1 + std::sqrt(1.5), 1e-15);
  EXPECT_LE(local.defect_across, 3e-14);
  EXPECT_GT(local.reach, 5);
}

TEST(LocalManifold, OfAFlowToTheToleranceOfTheIntegration) {
  const System system = make_system("ovp");
  const LocalManifold local = local_manifold(*system.map, {1.45, 0}, ManifoldSide::unstable);
  EXPECT_NEAR(local.saddle.x, 1.451260038107551142, 1e-12);
  EXPECT_NEAR(local.multiplier, 5.075684315001539492, 1e-10);
  EXPECT_GT(local.reach, 0.1);
  EXPECT_LE(local.defect_across, 1e-11);
}

TEST(LocalManifold, PeriodTwo) {
  // Two applications have the same manifold.
  const StandardMap map(1.2);
  const LocalManifold one = local_manifold(map, {0, 0}, ManifoldSide::unstable);
  const LocalManifold two = local_manifold(map, {0, 0}, ManifoldSide::unstable, {.period = 2});
  EXPECT_NEAR(two.multiplier, one.multiplier * one.multiplier, 1e-11);
  const Point a = one.at(1.5), b = two.at(1.5);
  EXPECT_NEAR(a.x, b.x, 1e-12);
  EXPECT_NEAR(a.y, b.y, 1e-12);
}

TEST(LocalManifold, RefusesWhatIsNoSaddle) {
  const StandardMap map(1.2);  // (pi, 0) is a centre
  try {
    (void)local_manifold(map, {3.14, 0.01}, ManifoldSide::unstable);
    FAIL();
  } catch (const DataError& error) {
    EXPECT_NE(std::string(error.what()).find("not a saddle"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("(3.14159"), std::string::npos);
  }
  EXPECT_THROW((void)local_manifold(HenonMap(-3), {0, 0}, ManifoldSide::unstable), DataError);  // no fixed point at all
  EXPECT_THROW((void)local_manifold(map, {0, 0}, ManifoldSide::unstable, {.period = 0}), UsageError);
  EXPECT_THROW((void)local_manifold(map, {0, 0}, ManifoldSide::unstable, {.tolerance = 0}), UsageError);
  EXPECT_THROW((void)local_manifold(map, {std::nan(""), 0}, ManifoldSide::unstable), UsageError);
}

// From that of a value nearby: the same curve, with the reach of the neighbour. From one too far off: as from nothing.
TEST(LocalManifold, IsContinuedFromThatOfANeighbour) {
  const auto vortices = [](double gamma) { return make_system("ovp", {{"gamma", gamma}}); };
  const System here = vortices(1.31), near = vortices(1.3), far = vortices(0.2);
  for (const ManifoldSide side : {ManifoldSide::unstable, ManifoldSide::stable}) {
    const auto of = [&](const System& system, const LocalManifold* neighbour) {
      return local_manifold(*system.map, system.connection->saddle(side), side, {.neighbour = neighbour});
    };
    const LocalManifold alone = of(here, nullptr), neighbour = of(near, nullptr), distant = of(far, nullptr);
    const LocalManifold continued = of(here, &neighbour);
    EXPECT_EQ(continued.reach, neighbour.reach);
    EXPECT_NE(continued.reach, alone.reach);
    EXPECT_LE(continued.defect_across, 2 * std::max(1e-14, neighbour.noise_across));
    EXPECT_NEAR(continued.multiplier, alone.multiplier, 1e-9 * std::fabs(alone.multiplier));
    const double end = std::min(continued.reach, alone.reach);
    for (int k = -8; k <= 8; ++k) {
      const Point a = continued.at(end * k / 8), b = alone.at(end * k / 8);
      EXPECT_LT(std::hypot(a.x - b.x, a.y - b.y), 1e-11) << k;
    }
    const LocalManifold restarted = of(here, &distant);
    EXPECT_EQ(restarted.reach, alone.reach);
    EXPECT_EQ(restarted.coefficients, alone.coefficients);
  }
}

}  // namespace
}  // namespace lober
