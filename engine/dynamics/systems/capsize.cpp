// Roll and pitch of a ship, coupled (Thompson & de Souza 1996; Naik & Ross 2017).
#include <array>
#include <cmath>

#include "engine/dynamics/maps/flow_of.hpp"
#include "engine/dynamics/systems/entries.hpp"

namespace lober::detail {

namespace {

/// State (x, y, vx, vy): x'' = -x + 2 x y, y'' = -R^2 y + R^2 x^2 / 2, with the energy
/// vx^2 / 2 + vy^2 / R^2 + x^2 / 2 + y^2 - x^2 y. Momenta are vx and (2 / R^2) vy.
class Capsize {
 public:
  static constexpr int dimension = 4;
  explicit Capsize(double r) : r2_(r * r), pairs_{{{0, 2, 1}, {1, 3, 2 / (r * r)}}} {}

  [[nodiscard]] static double period() { return 0; }
  [[nodiscard]] std::span<const ConjugatePair> pairs() const { return pairs_; }
  template <typename T>
  void velocity(const T* x, T* dxdt, double /*t*/) const {
    dxdt[0] = x[2];
    dxdt[1] = x[3];
    dxdt[2] = x[0] * (2.0 * x[1] - 1.0);
    dxdt[3] = r2_ * (0.5 * (x[0] * x[0]) - x[1]);
  }
  double hamiltonian(const double* x, double /*t*/) const {
    return 0.5 * (x[2] * x[2] + x[0] * x[0]) + x[3] * x[3] / r2_ + x[1] * (x[1] - x[0] * x[0]);
  }

 private:
  double r2_;
  std::array<ConjugatePair, 2> pairs_;
};

}  // namespace

SystemEntry capsize_entry() {
  const SystemInfo info{
      "capsize",
      "Ship capsize: roll x'' = -x + 2 x y, pitch y'' = -R^2 y + R^2 x^2 / 2; return map to x = 0, vx > 0 "
      "in (y, vy)",
      {{"R", 1.6, "ratio of the natural frequencies of pitch and roll"},
       {"energy", 0.25307, "total energy; saddles are at 0.25"}}};
  return {info, [info](std::span<const double> values, const IntegrationOptions& options) {
            require_positive(info, "R", values[0]);
            require_positive(info, "energy", values[1]);
            System system;
            const double reach = std::sqrt(values[1]);
            system.window = window(-reach, -values[0] * reach, reach, values[0] * reach);
            system.flow = std::make_shared<FlowOf<Capsize>>(Capsize(values[0]));
            system.saddles = {FlowState{-1, 0.5}, FlowState{1, 0.5}};
            system.section =
                Section{.coordinate = 0, .value = 0, .direction = 1, .chart_x = 1, .chart_y = 3, .solved = 2};
            system.symmetries = {reversor({1, 0, 0, -1})};
            system.map = system.flow->section_map(*system.section, values[1], options);
            return system;
          }};
}

}  // namespace lober::detail
