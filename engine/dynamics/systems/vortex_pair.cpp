// The oscillating vortex pair of Rom-Kedar, Leonard & Wiggins (1990): a passive particle near two counter-rotating
// vortices in an oscillating strain, in the frame that moves with their mean velocity.
#include "engine/dynamics/systems/fields/vortex_pair.hpp"

#include <algorithm>
#include <cmath>

#include "engine/base/text.hpp"
#include "engine/dynamics/maps/flow_of.hpp"
#include "engine/dynamics/systems/entries.hpp"
#include "engine/dynamics/systems/follow_saddle.hpp"

namespace lober::detail {

namespace {

// The saddles of the pair in a strain that does not oscillate are at +-sqrt(3).
constexpr double saddle_at_rest = 1.7320508075688772;
// Strains up to which the saddles are near enough to 1.5 and -1.5 in the phase 0.
constexpr double own_reach = 0.5;
// Largest change of the strain and move of the saddle from step to step when it is followed.
constexpr double largest_change = 0.02, longest_move = 0.3;

// The boundaries begin at the one saddle and end at the other, or there are none.
template <typename MapAt>
void follow_saddles(System& system, const MapAt& map_at, double strain) {
  const double step = 1 / std::max(1.0, std::fabs(strain) / largest_change);
  double lowest = 0, highest = 0;
  for (const bool first : {true, false}) {
    const FollowedSaddle saddle = follow_saddle(map_at, first ? saddle_at_rest : -saddle_at_rest, step, longest_move);
    if (!saddle.point) {
      system.connection.reset();
      system.further.clear();
      system.no_connection = "on the way there from eps = 0 the saddle of its tangle is lost near eps = " +
                             format_rounded(saddle.reached * strain, 4);
      return;
    }
    for (Connection* const boundary : {&*system.connection, &system.further[0]}) {
      (first ? boundary->from : boundary->to) = saddle.point->at;
    }
    lowest = std::min(lowest, saddle.point->at.x);
    highest = std::max(highest, saddle.point->at.x);
  }
  system.window = window(1.2 * lowest, -0.1, 1.2 * highest, 0.1);
}

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
            // Near its own parameters the guesses above do.
            if (!(values[1] >= 0 && values[1] <= own_reach && values[2] == 0)) {
              const auto map_at = [&](double part) {
                return FlowOf<Field>(Field(values[0], part * values[1])).stroboscopic_map(values[2], options);
              };
              follow_saddles(system, map_at, values[1]);
            }
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
