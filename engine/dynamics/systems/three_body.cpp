// The planar circular restricted three-body problem.
#include <array>
#include <cmath>

#include "engine/dynamics/maps/flow_of.hpp"
#include "engine/dynamics/systems/entries.hpp"
#include "engine/dynamics/systems/fields/three_body.hpp"
#include "kernels/elementary.hpp"

namespace lober::detail {

SystemEntry three_body_entry() {
  const SystemInfo info{"pcr3bp",
                        "Planar circular restricted three-body problem; return map to y = 0, x < -1, y' > 0 in (x, x')",
                        {{"mu", 9.537e-4, "mass ratio", 0, 0.5}, {"energy", -1.525, "H, the Jacobi constant is -2 H"}}};
  return {info, [](std::span<const double> values, const IntegrationOptions& options) {
            System system;
            system.window = window(-3, -0.5, -1.05, 0.5);
            // The inner branch; its pip on the axis of the reversor.
            system.connection = Connection{{-2.03, 0}, {1, 0.29}, {-2.03, 0}, {1, -0.29}, Point{-1.15, 0}};
            system.flow = std::make_shared<FlowOf<ThreeBody>>(ThreeBody{values[0]});
            // L1 and L2, at Hill's distance from the smaller body.
            const double hill = elementary::cbrt(values[0] / 3), one = 1 - values[0] - hill, two = 1 - values[0] + hill;
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
