// The planar circular restricted three-body problem.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "engine/base/text.hpp"
#include "engine/dynamics/maps/flow_of.hpp"
#include "engine/dynamics/systems/entries.hpp"
#include "engine/dynamics/systems/fields/three_body.hpp"
#include "kernels/elementary.hpp"
#include "lober/error.hpp"
#include "lober/fixed_points.hpp"

namespace lober::detail {
namespace {

using Parameters = std::array<double, 2>;  // mu, energy
constexpr Parameters own_parameters{9.537e-4, -1.525};
constexpr double own_saddle = -2.03;

struct FollowedSaddle {
  std::optional<FixedPoint> point;  // none: lost on the way
  Parameters reached = own_parameters;
};

// On the way from the system's own parameters to others: mu by factors, the energy by sums.
Parameters on_the_way(const Parameters& wanted, double part) {
  if (part == 1) return wanted;
  const double growth = elementary::log(wanted[0] / own_parameters[0]);
  return {wanted[0] > 0 ? own_parameters[0] * elementary::exp(part * growth) : own_parameters[0] * (1 - part),
          own_parameters[1] + part * (wanted[1] - own_parameters[1])};
}

// The saddle on the axis of the reversor that the system's own one becomes on the way to other parameters. Newton's
// method needs a good guess next to orbits that nearly collide, and fails slowly: short steps, halved where the saddle
// is lost. `map_of(parameters)` makes the map.
template <typename MapOf>
FollowedSaddle follow_saddle(const MapOf& map_of, const Parameters& wanted) {
  constexpr double largest_growth = 0.02, largest_change = 1e-3, on_axis = 1e-9, longest_move = 0.02;
  const double growth = wanted[0] > 0 ? std::fabs(elementary::log(wanted[0] / own_parameters[0])) : 1;
  const double longest =
      1 / std::max({1.0, growth / largest_growth, std::fabs(wanted[1] - own_parameters[1]) / largest_change});
  FollowedSaddle result;
  double x = own_saddle, slope = 0, done = 0, step = longest;
  while (done < 1 && step > longest / 8) {
    const double next = done + step > 1 - 1e-9 ? 1 : done + step;
    const double guess = x + slope * (next - done);
    std::optional<FixedPoint> found;
    try {
      found = find_fixed_point(*map_of(on_the_way(wanted, next)), {guess, 0});
    } catch (const DataError&) {  // none there
    }
    if (found && found->kind == FixedPointKind::saddle && std::fabs(found->at.y) < on_axis &&
        std::fabs(found->at.x - guess) < longest_move) {
      if (result.point) slope = (found->at.x - x) / (next - done);
      x = found->at.x;
      done = next;
      step = std::min(2 * step, longest);
      result = {found, on_the_way(wanted, next)};
    } else {
      step /= 2;
    }
  }
  if (done < 1) result.point.reset();
  return result;
}

}  // namespace

SystemEntry three_body_entry() {
  const SystemInfo info{"pcr3bp",
                        "Planar circular restricted three-body problem; return map to y = 0, x < -1, y' > 0 in (x, x')",
                        {{"mu", own_parameters[0], "mass ratio", 0, 0.5},
                         {"energy", own_parameters[1], "H, the Jacobi constant is -2 H"}}};
  return {info, [](std::span<const double> values, const IntegrationOptions& options) {
            System system;
            system.window = window(-3, -0.5, -1.05, 0.5);
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
            // The inner branch; its pip on the axis of the reversor.
            system.connection = Connection{{own_saddle, 0}, {1, 0.29}, {own_saddle, 0}, {1, -0.29}, Point{-1.15, 0}};
            if (const Parameters wanted{values[0], values[1]}; wanted != own_parameters) {
              const auto map_of = [&](const Parameters& parameters) {
                return FlowOf<ThreeBody>(ThreeBody{parameters[0]}).section_map(*system.section, parameters[1], options);
              };
              const FollowedSaddle saddle = follow_saddle(map_of, wanted);
              if (saddle.point) {
                // The reversor exchanges the two directions.
                const Point u = saddle.point->directions[0];
                system.connection->from = system.connection->to = saddle.point->at;
                system.connection->u_direction = u;
                system.connection->s_direction = {u.x, -u.y};
              } else {
                system.connection.reset();
                system.no_connection =
                    "on the way there from its own parameters the saddle of its tangle is lost near mu = " +
                    format_rounded(saddle.reached[0]) + ", energy = " + format_rounded(saddle.reached[1]);
              }
            }
            return system;
          }};
}

}  // namespace lober::detail
