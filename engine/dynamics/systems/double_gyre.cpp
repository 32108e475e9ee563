// The double gyre of Shadden, Lekien & Marsden (2005).
#include <array>
#include <cmath>
#include <numbers>

#include "engine/dynamics/maps/flow_of.hpp"
#include "engine/dynamics/systems/entries.hpp"

namespace lober::detail {

namespace {

/// x' = -pi A sin(pi f) cos(pi y), y' = pi A cos(pi f) sin(pi y) df/dx, with f = a x^2 + (1 - 2 a) x and
/// a = eps sin(omega t); the stream function A sin(pi f) sin(pi y) is minus the Hamiltonian.
struct DoubleGyre {
  static constexpr int dimension = 2;
  double amplitude, eps, omega;

  [[nodiscard]] double period() const { return 2 * std::numbers::pi / omega; }
  [[nodiscard]] std::span<const ConjugatePair> pairs() const {
    static constexpr std::array<ConjugatePair, 1> pair{{{0, 1, 1}}};
    return pair;
  }
  template <typename T>
  void velocity(const T* x, T* dxdt, double t) const {
    using std::cos, std::sin;
    constexpr double pi = std::numbers::pi;
    const double a = eps * std::sin(omega * t);
    const T f = pi * (x[0] * (a * x[0] + (1 - 2 * a)));
    const T y = pi * x[1];
    dxdt[0] = -pi * amplitude * (sin(f) * cos(y));
    dxdt[1] = pi * amplitude * (cos(f) * sin(y)) * (2 * a * x[0] + (1 - 2 * a));
  }
  double hamiltonian(const double* x, double t) const {
    constexpr double pi = std::numbers::pi;
    const double a = eps * std::sin(omega * t);
    return -amplitude * std::sin(pi * x[0] * (a * x[0] + (1 - 2 * a))) * std::sin(pi * x[1]);
  }
};

}  // namespace

SystemEntry double_gyre_entry() {
  const SystemInfo info{"double-gyre",
                        "Double gyre (Shadden, Lekien & Marsden 2005) in [0, 2] x [0, 1]; period map",
                        {{"A", 0.1, "amplitude of the stream function"},
                         {"eps", 0.1, "amplitude of the wall's motion"},
                         {"omega", 2 * std::numbers::pi / 10, "frequency of the wall's motion"},
                         {"phase", 0, "of the section, as a fraction of the period"}}};
  return {info, [info](std::span<const double> values, const IntegrationOptions& options) {
            require_positive(info, "omega", values[2]);
            System system;
            system.window = window(0, 0, 2, 1);
            // The left gyre: its other sides are walls.
            system.connection = Connection{{1, 1}, {0, -1}, {1, 0}, {0, 1}, {}, {{0, 0}, {0, 1}}};
            if (at_half_periods(values[3])) system.symmetries.push_back(reversor({-1, 0, 0, -1}, {2, 1}));
            if (at_quarter_periods(values[3])) system.symmetries.push_back(reversor({1, 0, 0, -1}, {0, 1}));
            system.flow = std::make_shared<FlowOf<DoubleGyre>>(DoubleGyre{values[0], values[1], values[2]});
            system.map = system.flow->stroboscopic_map(values[3], options);
            return system;
          }};
}

}  // namespace lober::detail
