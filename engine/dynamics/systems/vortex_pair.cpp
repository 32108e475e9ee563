// The oscillating vortex pair of Rom-Kedar, Leonard & Wiggins (1990): a passive particle near two counter-rotating
// vortices in an oscillating strain, in the frame that moves with their mean velocity.
#include "engine/dynamics/systems/fields/vortex_pair.hpp"

#include "engine/dynamics/maps/flow_of.hpp"
#include "engine/dynamics/systems/entries.hpp"

namespace lober::detail {

namespace {

template <typename Field>
SystemEntry entry(const char* name, const char* summary) {
  SystemInfo info{name,
                  summary,
                  {positive("gamma", 0.5, "dimensionless period of the strain over 2 pi"),
                   // Forty terms of the vortices' motion are kept: more than enough up to 8.
                   {"eps", 0.1, "amplitude of the strain", -8, 8, false, false, true},
                   {"phase", 0, "of the section, as a fraction of the period"}}};
  return {info, [](std::span<const double> values, const IntegrationOptions& options) {
            System system;
            system.window = window(-2.2, -0.1, 2.2, 0.1);
            system.picture = window(-2.5, -2.5, 2.5, 2.5);  // the fluid that travels with the pair
            // The upper boundary of the fluid that travels with the pair.
            system.connection = Connection{{1.5, 0}, {0, 1}, {-1.5, 0}, {0, 1}, Point{0, 2.05}};
            // The lower one. Both are closed by the axis y = 0, which no fluid crosses.
            system.further = {Connection{{1.5, 0}, {0, -1}, {-1.5, 0}, {0, -1}, Point{0, -2.05}}};
            system.symmetries = {{{1, 0, 0, -1}}};
            if (at_half_periods(values[2])) system.symmetries.push_back(reversor({-1, 0, 0, 1}));
            system.flow = std::make_shared<FlowOf<Field>>(Field(values[0], values[1]));
            system.map = system.flow->stroboscopic_map(values[2], options);
            return system;
          }};
}

}  // namespace

SystemEntry vortex_pair_entry() {
  return entry<VortexPair>("ovp",
                           "Oscillating vortex pair (Rom-Kedar, Leonard & Wiggins 1990), vortices move; period map");
}

SystemEntry first_order_vortex_pair_entry() {
  return entry<FirstOrderVortexPair>("ovp1", "Oscillating vortex pair to first order in eps; period map");
}

}  // namespace lober::detail
