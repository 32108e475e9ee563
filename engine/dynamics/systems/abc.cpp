// The flow of Arnold, Beltrami and Childress on the torus (Dombre et al., Journal of Fluid Mechanics 167, 1986).
#include <numbers>

#include "engine/dynamics/maps/flow_of.hpp"
#include "engine/dynamics/systems/entries.hpp"
#include "engine/dynamics/systems/fields/abc.hpp"

namespace lober::detail {

// The flow preserves volume, hence its return map z' dx dy, not the area dx dy.
SystemEntry abc_entry() {
  const SystemInfo info{"abc",
                        "ABC flow x' = A sin z + C cos y, y' = B sin x + A cos z, z' = C sin y + B cos x; return map "
                        "to z = 0 mod 2 pi, z' > 0 in the angles (x, y)",
                        {{"A", std::numbers::sqrt3, "amplitude of the wave along z"},
                         {"B", std::numbers::sqrt2, "amplitude of the wave along x"},
                         {"C", 1, "amplitude of the wave along y; 0 for a flow that can be integrated"}}};
  return {info, [](std::span<const double> values, const IntegrationOptions& options) {
            constexpr double pi = std::numbers::pi;
            System system;
            system.window = window(-pi, -pi, pi, pi);
            system.lattice = {2 * pi, 0};
            system.second_lattice = {0, 2 * pi};
            system.flow = std::make_shared<FlowOf<Abc>>(Abc{values[0], values[1], values[2]});
            system.section = Section{.coordinate = 2, .direction = 1, .chart_x = 0, .chart_y = 1, .period = 2 * pi};
            system.symmetries = {reversor({1, 0, 0, -1}, {0, pi})};
            system.map = system.flow->section_map(*system.section, 0, options);
            return system;
          }};
}

}  // namespace lober::detail
