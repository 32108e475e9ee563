// Periodic orbits about saddles against quadruple precision, and against identities that hold for any system.
#include "lober/dynamics/periodic_orbit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "lober/base/error.hpp"
#include "lober/dynamics/systems.hpp"

namespace lober {
namespace {

constexpr IntegrationOptions finest{.tolerance = 3e-15};

PeriodicOrbit orbit_of(const System& system, const FlowState& near, double energy) {
  return periodic_orbit(*system.flow, saddle_point(*system.flow, near), energy, finest);
}

TEST(PeriodicOrbit, OfTheShipToTwelveDigits) {
  const System system = make_system("capsize");
  for (const double side : {1.0, -1.0}) {
    SCOPED_TRACE(side);
    const PeriodicOrbit orbit = orbit_of(system, {side * 0.9, 0.45}, 0.25307);
    EXPECT_NEAR(orbit.saddle.at[0], side, 1e-14);
    EXPECT_NEAR(orbit.saddle.at[1], 0.5, 1e-14);
    EXPECT_NEAR(orbit.saddle.energy, 0.25, 1e-15);
    EXPECT_NEAR(orbit.period, 3.189752742896737111, 1e-12);
    EXPECT_NEAR(orbit.action, 0.009792813781013887123, 1e-15);
    EXPECT_NEAR(orbit.multiplier, 39.09601030324, 1e-10);
    EXPECT_NEAR(orbit.trace_defect, 0, 1e-10);
    // A brake orbit; the lower end in y is the outer one in x.
    EXPECT_TRUE(orbit.brake);
    EXPECT_NEAR(orbit.turning[0][0], side * 1.0203846889635231911, 1e-13);
    EXPECT_NEAR(orbit.turning[0][1], 0.4614819731103741076, 1e-13);
    EXPECT_NEAR(orbit.turning[1][0], side * 0.9803015914277921007, 1e-13);
    // At rest, all energy is potential: y^2 - x^2 y + x^2 / 2 = E.
    const double x2 = 0.9803015914277921007 * 0.9803015914277921007;
    EXPECT_NEAR(orbit.turning[1][1], 0.5 * (x2 + std::sqrt(x2 * x2 - 2 * x2 + 4 * 0.25307)), 1e-13);
  }
}

TEST(PeriodicOrbit, ActionGrowsWithEnergyAsThePeriod) {
  // dJ/dE = T along a family of periodic orbits.
  constexpr double step = 1e-4;
  for (const char* const name : {"capsize", "pcr3bp"}) {
    SCOPED_TRACE(name);
    const System system = make_system(name);
    for (const FlowState& saddle : system.saddles) {
      const double energy = saddle_point(*system.flow, saddle).energy + 3e-3;
      const PeriodicOrbit here = orbit_of(system, saddle, energy);
      const double slope =
          (8 * (orbit_of(system, saddle, energy + step).action - orbit_of(system, saddle, energy - step).action) -
           (orbit_of(system, saddle, energy + 2 * step).action - orbit_of(system, saddle, energy - 2 * step).action)) /
          (12 * step);
      EXPECT_NEAR(slope, here.period, 1e-8);
      EXPECT_NEAR(here.trace_defect / here.multiplier, 0, 1e-8);
    }
  }
}

TEST(PeriodicOrbit, ShrinksToTheLinearOne) {
  const System system = make_system("capsize");
  const SaddlePoint saddle = saddle_point(*system.flow, {1, 0.5});
  const PeriodicOrbit orbit = periodic_orbit(*system.flow, saddle, 0.25 + 1e-6, finest);
  const double period = 2 * 3.14159265358979323846 / saddle.frequency;
  EXPECT_NEAR(orbit.period, period, 1e-4);
  EXPECT_NEAR(orbit.multiplier, std::exp(saddle.rate * period), 1e-2);
}

// The smallest orbits that can be asked for, whose energies above the saddle have lost half of their digits.
TEST(PeriodicOrbit, BeginsNextToTheSaddle) {
  for (const char* const name : {"capsize", "pcr3bp"}) {
    const System system = make_system(name);
    for (const FlowState& guess : system.saddles) {
      const SaddlePoint saddle = saddle_point(*system.flow, guess);
      const double excess = 1e-7 * (1 + std::fabs(saddle.energy));
      const PeriodicOrbit orbit = periodic_orbit(*system.flow, saddle, saddle.energy + excess, finest);
      // d(action)/d(energy) is the period.
      EXPECT_NEAR(orbit.action / (orbit.period * excess), 1, 1e-5) << name;
    }
  }
}

TEST(PeriodicOrbit, LyapunovOrbitsAreSymmetric) {
  const System system = make_system("pcr3bp");
  for (const FlowState& saddle : system.saddles) {
    const PeriodicOrbit orbit = orbit_of(system, saddle, -1.515);
    // Crossed at right angles: x' = px + y = 0.
    EXPECT_NEAR(orbit.state[2] + orbit.state[1], 0, 1e-10);
    EXPECT_NEAR(orbit.turning[0][1], -orbit.turning[1][1], 1e-10);
    EXPECT_FALSE(orbit.brake);
  }
}

// Each state is taken to the next one, where the halves from either side meet too, and the last one to the first.
TEST(PeriodicOrbit, StatesAlongItFollowEachOther) {
  for (const char* const name : {"capsize", "pcr3bp"}) {
    const System system = make_system(name);
    const PeriodicOrbit orbit = orbit_of(system, system.saddles[0], name == std::string("capsize") ? 0.25307 : -1.515);
    constexpr std::size_t count = 31;
    const std::vector<FlowState> states = states_along(*system.flow, orbit, count, finest);
    ASSERT_EQ(states.size(), count);
    EXPECT_EQ(states[0], orbit.state);
    for (std::size_t k = 0; k < count; ++k) {
      FlowState next = states[k];
      system.flow->integrate({&next, 1}, 0, orbit.period / count, finest);
      for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(next[i], states[(k + 1) % count][i], 1e-9) << name << " " << k;
    }
  }
}

TEST(PeriodicOrbit, SaysWhatIsWrong) {
  const System ship = make_system("capsize");
  EXPECT_THROW((void)orbit_of(ship, {1, 0.5}, 0.25), UsageError);
  EXPECT_THROW((void)saddle_point(*ship.flow, {0.01, 0.01}), DataError);  // the bottom of the well
  const System duffing = make_system("duffing");
  EXPECT_THROW((void)saddle_point(*duffing.flow, {}), UsageError);
}

}  // namespace
}  // namespace lober
