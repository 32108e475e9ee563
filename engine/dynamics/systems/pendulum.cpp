// The forced pendulum.
#include <cmath>
#include <numbers>

#include "engine/dynamics/maps/flow_of.hpp"
#include "engine/dynamics/systems/entries.hpp"
#include "engine/dynamics/systems/fields/pendulum.hpp"
#include "engine/dynamics/systems/forced_oscillator.hpp"
#include "kernels/elementary.hpp"

namespace lober::detail {

SystemEntry pendulum_entry() {
  const SystemInfo info{"pendulum",
                        "Forced pendulum x'' = -sin x - delta x' + eps cos(omega t), x lifted; period map in (x, x')",
                        {perturbation("eps", 0.1, "amplitude of the torque"),
                         positive("omega", 1, "frequency of the torque"),
                         {"delta", 0, "damping; 0 for a Hamiltonian system"},
                         {"phase", 0, "of the section, as a fraction of the period"}}};
  return {info, [](std::span<const double> values, const IntegrationOptions& options) {
            System system;
            system.window = window(-4, -2.5, 4, 2.5);
            system.lattice = {2 * std::numbers::pi, 0};
            const Pendulum flow{{values[0], values[1], values[2]}};
            const Point saddle = flow.saddle_on_section(values[3], [](double u) { return elementary::sin(u) - u; });
            system.connection = Connection{
                {saddle.x - std::numbers::pi, saddle.y}, {1, 1}, {saddle.x + std::numbers::pi, saddle.y}, {-1, 1}};
            // Below, from right to left: the region is the strip of the cylinder between both.
            system.further = {Connection{
                {saddle.x + std::numbers::pi, saddle.y}, {-1, -1}, {saddle.x - std::numbers::pi, saddle.y}, {1, -1}}};
            system.further_needed = true;
            system.symmetries = flow.symmetries(values[3]);
            system.flow = std::make_shared<FlowOf<Pendulum>>(flow);
            system.map = system.flow->stroboscopic_map(values[3], options);
            return system;
          }};
}

}  // namespace lober::detail
