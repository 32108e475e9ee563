// The planar circular restricted three-body problem.
#include <array>
#include <cmath>

#include "engine/dynamics/maps/flow_of.hpp"
#include "engine/dynamics/systems/entries.hpp"

namespace lober::detail {

namespace {

/// State (x, y, px, py) in the rotating frame, 1 - mu at (-mu, 0) and mu at (1 - mu, 0):
/// H = (px^2 + py^2) / 2 + px y - py x - (1 - mu) / r1 - mu / r2 - mu (1 - mu) / 2.
struct ThreeBody {
  static constexpr int dimension = 4;
  double mu;

  [[nodiscard]] static double period() { return 0; }
  [[nodiscard]] static std::span<const ConjugatePair> pairs() {
    static constexpr std::array<ConjugatePair, 2> pairs{{{0, 2, 1}, {1, 3, 1}}};
    return pairs;
  }
  template <typename T>
  void velocity(const T* x, T* dxdt, double /*t*/) const {
    using std::sqrt;
    const T a = x[0] + mu;
    const T b = x[0] - (1 - mu);
    const T square = x[1] * x[1];
    const T r1 = a * a + square;
    const T r2 = b * b + square;
    const T pull1 = (1 - mu) / (r1 * sqrt(r1));
    const T pull2 = mu / (r2 * sqrt(r2));
    dxdt[0] = x[2] + x[1];
    dxdt[1] = x[3] - x[0];
    dxdt[2] = x[3] - a * pull1 - b * pull2;
    dxdt[3] = -x[2] - x[1] * (pull1 + pull2);
  }
  double hamiltonian(const double* x, double /*t*/) const {
    return 0.5 * (x[2] * x[2] + x[3] * x[3]) + x[2] * x[1] - x[3] * x[0] - (1 - mu) / std::hypot(x[0] + mu, x[1]) -
           mu / std::hypot(x[0] - (1 - mu), x[1]) - 0.5 * mu * (1 - mu);
  }
};

}  // namespace

SystemEntry three_body_entry() {
  const SystemInfo info{"pcr3bp",
                        "Planar circular restricted three-body problem; return map to y = 0, x < -1, y' > 0 in (x, x')",
                        {{"mu", 9.537e-4, "mass ratio"}, {"energy", -1.525, "H, the Jacobi constant is -2 H"}}};
  return {info, [info](std::span<const double> values, const IntegrationOptions& options) {
            if (!(values[0] >= 0 && values[0] <= 0.5)) throw UsageError("system pcr3bp: mu must be in [0, 0.5]");
            System system;
            system.window = window(-3, -0.5, -1.05, 0.5);
            // The inner branch; its pip on the axis of the reversor.
            system.connection = Connection{{-2.03, 0}, {1, 0.29}, {-2.03, 0}, {1, -0.29}, Point{-1.15, 0}};
            system.flow = std::make_shared<FlowOf<ThreeBody>>(ThreeBody{values[0]});
            // L1 and L2, at Hill's distance from the smaller body.
            const double hill = std::cbrt(values[0] / 3), one = 1 - values[0] - hill, two = 1 - values[0] + hill;
            system.saddles = {FlowState{one, 0, 0, one}, FlowState{two, 0, 0, two}};
            system.section = Section{.coordinate = 1,
                                     .value = 0,
                                     .direction = 1,
                                     .chart_x = 0,
                                     .chart_y = 2,
                                     .solved = 3,
                                     .bound_coordinate = 0,
                                     .bound = -1,
                                     .bound_side = -1};
            system.symmetries = {reversor({1, 0, 0, -1})};
            system.map = system.flow->section_map(*system.section, values[1], options);
            return system;
          }};
}

}  // namespace lober::detail
