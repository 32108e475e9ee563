// Vector fields against their Hamiltonians and Jacobians, trajectories, crossings of sections.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "engine/dynamics/dynamics.hpp"
#include "lober/base/error.hpp"
#include "tests/paths.hpp"

namespace lober::detail {
namespace {

const std::vector<std::string> flows{"ovp",         "ovp1",    "duffing", "pendulum",
                                     "double-gyre", "capsize", "pcr3bp",  LOBER_EXAMPLES "/henon_heiles.so"};

FlowState some_state(std::size_t k) {
  const double s = static_cast<double>(k);
  return {0.3 + 0.21 * std::sin(s), 0.4 + 0.17 * std::cos(2 * s), 0.1 * std::sin(3 * s), 0.2 * std::cos(s), 0, 0};
}

/// d(function)/ds at 0, sixth order.
template <typename Function>
double slope(const Function& function) {
  const double h = 3e-3;
  return (45 * (function(h) - function(-h)) - 9 * (function(2 * h) - function(-2 * h)) + function(3 * h) -
          function(-3 * h)) /
         (60 * h);
}

TEST(Flows, HaveTheVelocityOfTheirHamiltonian) {
  for (const std::string& name : flows) {
    SCOPED_TRACE(name);
    const std::shared_ptr<const Flow> flow = make_system(name).flow;
    for (std::size_t k = 0; k < 5; ++k) {
      const FlowState z = some_state(k);
      const double time = 0.7 * static_cast<double>(k);
      const FlowState v = flow->velocity(z, time);
      const auto gradient = [&](int coordinate) {
        return slope([&](double h) {
          FlowState moved = z;
          moved[static_cast<std::size_t>(coordinate)] += h;
          return flow->hamiltonian(moved, time);
        });
      };
      ASSERT_EQ(2 * flow->conjugate_pairs().size(), static_cast<std::size_t>(flow->dimension()));
      for (const ConjugatePair& pair : flow->conjugate_pairs()) {
        EXPECT_NEAR(pair.factor * v[static_cast<std::size_t>(pair.q)], gradient(pair.p), 1e-9);
        EXPECT_NEAR(pair.factor * v[static_cast<std::size_t>(pair.p)], -gradient(pair.q), 1e-9);
      }
    }
  }
}

TEST(Flows, HaveTheJacobianOfTheirVelocity) {
  for (const std::string& name : flows) {
    SCOPED_TRACE(name);
    const std::shared_ptr<const Flow> flow = make_system(name).flow;
    const auto n = static_cast<std::size_t>(flow->dimension());
    for (std::size_t k = 0; k < 5; ++k) {
      const FlowState z = some_state(k);
      const double time = 0.7 * static_cast<double>(k);
      const FlowMatrix jacobian = flow->jacobian(z, time);
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
          const double expected = slope([&](double h) {
            FlowState moved = z;
            moved[j] += h;
            return flow->velocity(moved, time)[i];
          });
          EXPECT_NEAR(jacobian[i][j], expected, 1e-8) << i << j;
        }
      }
    }
  }
}

TEST(Flows, TheVortexPairsDifferBySecondOrder) {
  // The full model's expansion in eps: the difference falls with eps^2.
  const auto gap = [](double eps) {
    const FlowState z{0.8, 1.9};
    const auto full = make_system("ovp", {{"eps", eps}}).flow->velocity(z, 0.4);
    const auto first = make_system("ovp1", {{"eps", eps}}).flow->velocity(z, 0.4);
    return std::hypot(full[0] - first[0], full[1] - first[1]);
  };
  EXPECT_NEAR(gap(1e-3) / gap(1e-4), 100, 2);
}

TEST(Trajectories, KeepTheEnergyAndComeBack) {
  for (const char* const name : {"capsize", "pcr3bp"}) {
    SCOPED_TRACE(name);
    const System system = make_system(name);
    const Point z = name == std::string("capsize") ? Point{0.1, 0.2} : Point{-2.05, 0.01};
    const FlowState start = system.flow->on_section(*system.section, system.info.parameters[1].value, z);
    EXPECT_NEAR(system.flow->hamiltonian(start, 0), system.info.parameters[1].value, 4e-16);
    std::vector<FlowState> states{start};
    system.flow->integrate(states, 0, 20, {});
    EXPECT_NEAR(system.flow->hamiltonian(states[0], 0), system.info.parameters[1].value, 1e-11);
    system.flow->integrate(states, 20, 0, {});
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(states[0][k], start[k], 1e-9);
  }
}

TEST(Trajectories, OfTheShipsBrakeOrbit) {
  // Half the period from rest to rest, and the action over the whole.
  const System ship = make_system("capsize");
  const FlowState start{1.0203846889635231911, 0.4614819731103741076};
  constexpr double period = 3.189752742896737111;
  EXPECT_NEAR(ship.flow->hamiltonian(start, 0), 0.25307, 1e-15);
  double action = 0;
  FlowState end = ship.flow->integrate_with_action(start, 0, 0.5 * period, action, {.tolerance = 1e-15});
  EXPECT_NEAR(end[0], 0.9803015914277921007, 1e-12);
  EXPECT_NEAR(end[1], 0.5392358929668750286, 1e-12);
  EXPECT_NEAR(ship.flow->hamiltonian(end, 0), 0.25307, 1e-13);
  EXPECT_NEAR(end[2], 0, 1e-12);
  EXPECT_NEAR(end[3], 0, 1e-12);
  EXPECT_NEAR(2 * action, 0.009792813781013887123, 1e-13);
  // The monodromy matrix has the multipliers 39.096, 1/39.096, 1, 1.
  FlowMatrix m;
  end = ship.flow->integrate_with_derivative(start, 0, period, m, {.tolerance = 1e-15});
  EXPECT_NEAR(m[0][0] + m[1][1] + m[2][2] + m[3][3], 39.09601030324 + 1 / 39.09601030324 + 2, 1e-9);
}

// Boost.Odeint's Fehlberg 7(8) knows nothing of lanes, levels and tables.
TEST(Trajectories, AreThoseOfAnotherIntegrator) {
  namespace odeint = boost::numeric::odeint;
  for (const std::string& name : flows) {
    SCOPED_TRACE(name);
    const System system = make_system(name);
    const Flow& flow = *system.flow;
    const double period = flow.period() > 0 ? flow.period() : 7;
    const auto dimension = static_cast<std::size_t>(flow.dimension());
    for (std::size_t k = 0; k < 5; ++k) {
      FlowState expected = some_state(k);
      if (name.find("ovp") == 0) expected[1] += 1.6;  // not too near a vortex
      const FlowState start = expected;
      std::vector<FlowState> state{start};
      using State = std::vector<double>;  // of arrays GCC says that they may be uninitialised
      const auto stepper = odeint::make_controlled<odeint::runge_kutta_fehlberg78<State>>(1e-14, 1e-14);
      const auto velocity = [&](const State& x, State& dxdt, double t) {
        FlowState at{};
        std::copy(x.begin(), x.end(), at.begin());
        const FlowState v = flow.velocity(at, t);
        std::copy_n(v.begin(), x.size(), dxdt.begin());
      };
      State followed(expected.begin(), expected.begin() + static_cast<std::ptrdiff_t>(dimension));
      odeint::integrate_adaptive(stepper, velocity, followed, 0.0, period, 1e-3);
      std::copy(followed.begin(), followed.end(), expected.begin());
      flow.integrate(state, 0, period, {.tolerance = 1e-14});
      FlowMatrix stretch{};
      flow.integrate_with_derivative(start, 0, period, stretch, {});
      double size = 1, largest = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        largest = std::max(largest, std::fabs(expected[i]));
        for (std::size_t j = 0; j < 4; ++j) size = std::max(size, std::fabs(stretch[i][j]));
      }
      if (!(largest < 100)) continue;  // it escapes
      for (std::size_t i = 0; i < dimension; ++i) EXPECT_NEAR(state[0][i], expected[i], 1e-11 * size) << k;
      if (flow.period() == 0) continue;
      // The steps of the map are others again: whole fractions of the period.
      const auto map = flow.stroboscopic_map(0, {.tolerance = 1e-14});
      Point point{some_state(k)[0], some_state(k)[1] + (name.find("ovp") == 0 ? 1.6 : 0.0)};
      map->iterate({&point, 1}, 1);
      EXPECT_NEAR(point.x, expected[0], 1e-11 * size) << k;
      EXPECT_NEAR(point.y, expected[1], 1e-11 * size) << k;
    }
  }
}

TEST(Trajectories, ErrFallsWithTheTolerance) {
  const System duffing = make_system("duffing");
  const auto end = [&](double tolerance) {
    std::vector<FlowState> state{{0.5, 0.5}};
    duffing.flow->integrate(state, 0, 10, {.tolerance = tolerance});
    return state[0];
  };
  const FlowState best = end(1e-15);
  for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
    const FlowState here = end(tolerance);
    EXPECT_LT(std::hypot(here[0] - best[0], here[1] - best[1]), 100 * tolerance) << tolerance;
  }
}

TEST(Sections, AreMetExactlyAndInOrder) {
  const System ship = make_system("capsize");
  const FlowState start = ship.flow->on_section(*ship.section, 0.25307, {0.1, 0.2});
  Section either = *ship.section;
  either.direction = 0;
  double before = 0;
  for (int k = 1; k <= 6; ++k) {
    std::vector<FlowState> state{start};
    std::vector<double> time(1);
    ship.flow->to_section(state, time, either, k, {});
    EXPECT_EQ(state[0][0], 0);
    EXPECT_GT(time[0], before);
    EXPECT_EQ(state[0][2] > 0, k % 2 == 0);
    // At that time the trajectory is there.
    std::vector<FlowState> along{start};
    ship.flow->integrate(along, 0, time[0], {});
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(along[0][i], state[0][i], 1e-10);
    before = time[0];
  }
}

TEST(Sections, TwoCrossingsWithinAStepAreFound) {
  // The Henon-Heiles flow, nearly linear: x = sin t. A section just below the top is met twice within less than a step.
  const System system = make_system(LOBER_EXAMPLES "/henon_heiles.so", {{"energy", 0.5e-6}});
  const FlowState start{0, 0, 1e-3, 0};
  for (const double below : {1e-2, 1e-4, 1e-6, 1e-8}) {
    const Section top{
        .coordinate = 0, .value = 1e-3 * (1 - below), .direction = 1, .chart_x = 1, .chart_y = 3, .solved = 2};
    for (const int crossings : {1, -1}) {
      std::vector<FlowState> state{start};
      std::vector<double> time(1);
      IntegrationOptions loose;
      loose.tolerance = 1e-10;
      system.flow->to_section(state, time, top, crossings, loose);
      // Upwards before the top; backwards in time on the other side of the period.
      const double quarter = std::numbers::pi / 2 - std::acos(1 - below);
      EXPECT_NEAR(time[0], crossings > 0 ? quarter : quarter - 2 * std::numbers::pi, 0.02 * std::sqrt(below) + 1e-3)
          << below;
    }
  }
}

TEST(Sections, ThatDoNotFitAreRefused) {
  const System ship = make_system("capsize");
  Section bad = *ship.section;
  bad.solved = 1;
  EXPECT_THROW(static_cast<void>(ship.flow->section_map(bad, 0.25, {})), UsageError);
  EXPECT_THROW(static_cast<void>(ship.flow->stroboscopic_map(0, {})), UsageError);
  bad = *ship.section;
  bad.direction = 0;
  EXPECT_THROW(static_cast<void>(ship.flow->section_map(bad, 0.25, {})), UsageError);
  EXPECT_THROW(static_cast<void>(make_system("ovp").flow->section_map(*ship.section, 0.25, {})), UsageError);
}

}  // namespace
}  // namespace lober::detail
