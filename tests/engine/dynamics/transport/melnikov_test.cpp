// Melnikov's function against closed forms, and its areas against exact ones.
#include "lober/transport/melnikov.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "lober/base/error.hpp"
#include "lober/tangle/manifold_tangle.hpp"

namespace lober {
namespace {

using std::numbers::pi;

struct Member {
  std::string name;
  ParameterValues fixed;
  [[nodiscard]] System at(double eps) const {
    ParameterValues values = fixed;
    values.emplace_back("eps", eps);
    return make_system(name, values);
  }
  [[nodiscard]] Melnikov function() const {
    const System system = at(0.1);
    return melnikov([this](double eps) { return at(eps).flow; }, *system.connection);
  }
  // The area of the lobes on the left of U, by action.
  [[nodiscard]] double exact(double eps) const {
    const System system = at(eps);
    ManifoldTangleOptions options;
    const auto tangle = grow_tangle(*system.map, *system.connection, options);
    double left = 0;
    for (const double area : tangle->areas_by_action) left += std::max(area, 0.0);
    return left;
  }
};

// x = sqrt(2) sech t: |M| = sqrt(2) pi omega sech(pi omega / 2) |sin(omega t0 + phase)|.
TEST(Melnikov, IsThatOfTheDuffingOscillator) {
  for (const double omega : {0.5, 1.0, 2.0, 5.0}) {
    const Melnikov m = Member{"duffing", {{"omega", omega}}}.function();
    const double amplitude = std::sqrt(2) * pi * omega / std::cosh(0.5 * pi * omega);
    EXPECT_NEAR(std::hypot(m.cosines[1], m.sines[1]), amplitude, 1e-8 * amplitude) << omega;
    EXPECT_NEAR(std::hypot(m.cosines[1], m.sines[1]), amplitude, m.error) << omega;
    ASSERT_EQ(m.zeros.size(), 2U) << omega;
    EXPECT_NEAR(m.lobe_areas(0.1).left, 0.1 * 2 * amplitude / omega, 1e-9) << omega;
    EXPECT_NEAR(m.lobe_areas(0.1).right, 0.1 * 2 * amplitude / omega, 1e-9) << omega;
    EXPECT_NEAR(m.at(m.zeros[0].t0), 0, 1e-13);
    EXPECT_NEAR(m.largest, amplitude, 1e-8 * amplitude);
  }
}

// x' = 2 sech t on the upper branch: |M| = 2 pi sech(pi omega / 2) |cos(omega t0 + phase)|.
TEST(Melnikov, IsThatOfThePendulum) {
  for (const double omega : {0.7, 1.0, 3.0}) {
    const Melnikov m = Member{"pendulum", {{"omega", omega}}}.function();
    const double amplitude = 2 * pi / std::cosh(0.5 * pi * omega);
    EXPECT_NEAR(std::hypot(m.cosines[1], m.sines[1]), amplitude, 1e-8 * amplitude) << omega;
    EXPECT_EQ(m.zeros.size(), 2U);
    EXPECT_NEAR(m.to.x - m.from.x, 2 * pi, 1e-12);
  }
}

// The area is eps M1 + eps^2 M2 + ...: what the estimate misses falls as eps^2 at least.
TEST(Melnikov, MissesTheSquareOfThePerturbation) {
  const Member members[] = {{"duffing", {{"omega", 1.0}}},
                            {"pendulum", {{"omega", 1.0}}},
                            {"ovp", {{"gamma", 0.5}}},
                            {"ovp1", {{"gamma", 0.5}}},
                            {"double-gyre", {{"omega", 2 * pi / 10}}}};
  for (const Member& member : members) {
    const Melnikov m = member.function();
    const double eps = 0.004;
    const double coarse = std::fabs(member.exact(eps) - m.lobe_areas(eps).left);
    const double fine = std::fabs(member.exact(eps / 2) - m.lobe_areas(eps / 2).left);
    EXPECT_LT(coarse, 0.2 * m.lobe_areas(eps).left) << member.name;
    EXPECT_LT(fine, coarse / 3.5) << member.name;
    EXPECT_GT(coarse, 0) << member.name;
  }
}

// To first order both models are one; g is known there in closed form up to eps.
TEST(Melnikov, IsTheSameForBothModelsOfTheVortexPair) {
  const Melnikov full = Member{"ovp", {{"gamma", 0.8}}}.function(), first = Member{"ovp1", {{"gamma", 0.8}}}.function();
  for (const double t0 : {0.0, 0.7, 2.1, 4.0}) EXPECT_NEAR(full.at(t0), first.at(t0), 1e-9);
  EXPECT_NEAR(full.from.x, std::sqrt(3), 1e-10);
}

TEST(Melnikov, SaysWhereThereIsNone) {
  // Damped, the manifolds are apart without the force.
  const Member damped{"duffing", {{"delta", 0.1}}};
  EXPECT_THROW((void)damped.function(), UsageError);
  // Not forced.
  const System ship = make_system("capsize");
  EXPECT_THROW((void)melnikov([&](double) { return ship.flow; }, Connection{{0, 0}, {1, 0}, {0, 0}, {1, 0}}),
               UsageError);
  // The branch that leaves for the left well does not come to the right side of the other one.
  const System pendulum = make_system("pendulum");
  Connection wrong = *pendulum.connection;
  wrong.u_direction = {-1, -1};
  EXPECT_THROW((void)melnikov(
                   [](double eps) {
                     return make_system("pendulum", {{"eps", eps}}).flow;
                   },
                   wrong),
               DataError);
  // A perturbation that does nothing has no zeros.
  const Melnikov nothing = melnikov(
      [](double) {
        return make_system("duffing", {{"eps", 0}}).flow;
      },
      *make_system("duffing").connection);
  EXPECT_TRUE(nothing.zeros.empty());
  EXPECT_EQ(nothing.lobe_areas(0.1).left, 0);
}

}  // namespace
}  // namespace lober
