// The forced Duffing oscillator.
#include <cmath>

#include "engine/dynamics/maps/flow_of.hpp"
#include "engine/dynamics/systems/entries.hpp"
#include "engine/dynamics/systems/fields/duffing.hpp"
#include "engine/dynamics/systems/forced_oscillator.hpp"

namespace lober::detail {

SystemEntry duffing_entry() {
  const SystemInfo info{"duffing",
                        "Duffing oscillator x'' = x - x^3 - delta x' + eps cos(omega t); period map in (x, x')",
                        {perturbation("eps", 0.1, "amplitude of the force"),
                         positive("omega", 1, "frequency of the force"),
                         {"delta", 0, "damping; 0 for a Hamiltonian system"},
                         {"phase", 0, "of the section, as a fraction of the period"}}};
  return {info, [](std::span<const double> values, const IntegrationOptions& options) {
            System system;
            system.window = window(-2, -1.5, 2, 1.5);
            const Duffing flow{{values[0], values[1], values[2]}};
            const Point saddle = flow.saddle_on_section(values[3], [](double u) { return -u * u * u; });
            system.connection = Connection{saddle, {1, 1}, saddle, {1, -1}};
            system.further = {Connection{saddle, {-1, -1}, saddle, {-1, 1}}};  // the left well
            system.symmetries = flow.symmetries(values[3]);
            system.flow = std::make_shared<FlowOf<Duffing>>(flow);
            system.map = system.flow->stroboscopic_map(values[3], options);
            return system;
          }};
}

}  // namespace lober::detail
