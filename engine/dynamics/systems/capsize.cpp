// Roll and pitch of a ship, coupled (Thompson & de Souza 1996; Naik & Ross 2017).
#include <array>
#include <cmath>

#include "engine/dynamics/maps/flow_of.hpp"
#include "engine/dynamics/systems/entries.hpp"
#include "engine/dynamics/systems/fields/capsize.hpp"

namespace lober::detail {

SystemEntry capsize_entry() {
  const SystemInfo info{
      "capsize",
      "Ship capsize: roll x'' = -x + 2 x y, pitch y'' = -R^2 y + R^2 x^2 / 2; return map to x = 0, vx > 0 "
      "in (y, vy)",
      {positive("R", 1.6, "ratio of the natural frequencies of pitch and roll"),
       positive("energy", 0.25307, "total energy; saddles are at 0.25")}};
  return {info, [](std::span<const double> values, const IntegrationOptions& options) {
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
