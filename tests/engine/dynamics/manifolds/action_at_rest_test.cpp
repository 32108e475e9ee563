// Actions where the state rests and the Hamiltonian does not: the error estimate of an integrator has to see a function
// of time alone (that of Fehlberg's pair of orders 7 and 8 does not).
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "engine/dynamics/maps/flow_of.hpp"
#include "lober/tangle/manifold_tangle.hpp"

namespace lober::detail {
namespace {

/// q'' = -(1 + 0.2 cos 3t) sin q, with a function of time added to H.
struct ParametricPendulum {
  static constexpr int dimension = 2;
  static constexpr std::size_t forcings = 2;
  static constexpr bool in_lanes = false;
  double added = 0;

  [[nodiscard]] double period() const { return 2 * std::numbers::pi / 3; }
  [[nodiscard]] std::span<const ConjugatePair> pairs() const {
    static constexpr std::array<ConjugatePair, 1> pair{{{0, 1, 1}}};
    return pair;
  }
  void forcing(double t, double* force) const {
    force[0] = 1 + 0.2 * std::cos(3 * t);
    force[1] = added * std::exp(std::sin(3 * t));
  }
  template <typename T, typename V>
  void velocity(const T* x, T* dxdt, const V* force) const {
    dxdt[0] = x[1];
    dxdt[1] = -(sine(x[0]) * force[0]);
  }
  double hamiltonian(const double* x, const double* force) const {
    return 0.5 * x[1] * x[1] - force[0] * std::cos(x[0]) + force[1];
  }
};

TEST(ActionAtRest, IsTheIntegralOfTheHamiltonian) {
  using std::numbers::pi;
  const double period = 2 * pi / 3;
  for (const double added : {0.0, 1.0, 30.0}) {
    const auto map = FlowOf<ParametricPendulum>({added}).stroboscopic_map(0, {});
    const auto action = map->action({pi, 0}, {pi, 0});
    ASSERT_TRUE(action.has_value());
    const double expected = -period * (1 + added * std::cyl_bessel_i(0.0, 1.0));
    EXPECT_NEAR(static_cast<double>(*action), expected, 1e-12 * (1 + std::fabs(expected)));
  }
}

TEST(ActionAtRest, AddingAFunctionOfTimeChangesNoLobe) {
  using std::numbers::pi;
  std::vector<double> first;
  for (const double added : {0.0, 1.0, 30.0}) {
    const auto map = FlowOf<ParametricPendulum>({added}).stroboscopic_map(0, {});
    const auto found = grow_tangle(*map, {{-pi, 0}, {1, 1}, {pi, 0}, {-1, 1}, {}});
    ASSERT_EQ(found->period(), found->areas_by_action.size());
    for (std::size_t k = 0; k < found->period(); ++k) {
      const Lobe& lobe = found->tangle.lobes[found->image_of_bip(-1) + k];
      EXPECT_LE(std::fabs(lobe.area - found->areas_by_action[k]), lobe.smooth_error + found->action_errors[k]) << added;
    }
    if (first.empty()) first = found->areas_by_action;
    ASSERT_EQ(first.size(), found->areas_by_action.size());
    for (std::size_t k = 0; k < first.size(); ++k) EXPECT_NEAR(found->areas_by_action[k], first[k], 1e-10) << added;
  }
}

}  // namespace
}  // namespace lober::detail
