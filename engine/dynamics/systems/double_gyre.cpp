// The double gyre of Shadden, Lekien & Marsden (2005).
#include <array>
#include <cmath>
#include <numbers>

#include "engine/dynamics/maps/flow_of.hpp"
#include "engine/dynamics/systems/entries.hpp"
#include "engine/dynamics/systems/fields/double_gyre.hpp"

namespace lober::detail {

SystemEntry double_gyre_entry() {
  const SystemInfo info{"double-gyre",
                        "Double gyre (Shadden, Lekien & Marsden 2005) in [0, 2] x [0, 1]; period map",
                        {{"A", 0.1, "amplitude of the stream function"},
                         perturbation("eps", 0.1, "amplitude of the wall's motion"),
                         positive("omega", 2 * std::numbers::pi / 10, "frequency of the wall's motion"),
                         {"phase", 0, "of the section, as a fraction of the period"}}};
  return {info, [](std::span<const double> values, const IntegrationOptions& options) {
            System system;
            system.window = window(0, 0, 2, 1);
            // The left gyre: its other sides are walls.
            system.connection = Connection{{1, 1}, {0, -1}, {1, 0}, {0, 1}, {}, {{0, 0}, {0, 1}}};
            if (values[0] < 0) {  // the gyres turn the other way
              system.connection = Connection{{1, 0}, {0, 1}, {1, 1}, {0, -1}, {}, {{0, 1}, {0, 0}}};
            }
            if (at_half_periods(values[3])) system.symmetries.push_back(reversor({-1, 0, 0, -1}, {2, 1}));
            if (at_quarter_periods(values[3])) system.symmetries.push_back(reversor({1, 0, 0, -1}, {0, 1}));
            system.flow = std::make_shared<FlowOf<DoubleGyre>>(DoubleGyre{values[0], values[1], values[2]});
            system.map = system.flow->stroboscopic_map(values[3], options);
            return system;
          }};
}

}  // namespace lober::detail
