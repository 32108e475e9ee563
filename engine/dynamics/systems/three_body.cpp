// The planar circular restricted three-body problem.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "engine/base/text.hpp"
#include "engine/dynamics/maps/flow_of.hpp"
#include "engine/dynamics/systems/entries.hpp"
#include "engine/dynamics/systems/fields/three_body.hpp"
#include "engine/dynamics/systems/follow_saddle.hpp"
#include "kernels/elementary.hpp"

namespace lober::detail {
namespace {

using Parameters = std::array<double, 2>;  // mu, energy
constexpr Parameters own_parameters{9.537e-4, -1.525};
constexpr double own_saddle = -2.03;

// On the way from the system's own parameters to others: mu by factors, the energy by sums.
Parameters on_the_way(const Parameters& wanted, double part) {
  if (part == 1) return wanted;
  const double growth = elementary::log(wanted[0] / own_parameters[0]);
  return {own_parameters[0] * elementary::exp(part * growth),
          own_parameters[1] + part * (wanted[1] - own_parameters[1])};
}

// The saddle on the axis of the reversor that the system's own one becomes. `map_of(parameters)` makes the map.
template <typename MapOf>
FollowedSaddle followed(const MapOf& map_of, const Parameters& wanted) {
  constexpr double largest_growth = 0.02, largest_change = 1e-3, longest_move = 0.02;
  const double growth = std::fabs(elementary::log(wanted[0] / own_parameters[0]));
  const double steps =
      std::max({1.0, growth / largest_growth, std::fabs(wanted[1] - own_parameters[1]) / largest_change});
  return follow_saddle([&](double part) { return map_of(on_the_way(wanted, part)); }, own_saddle, 1 / steps,
                       longest_move);
}

// The energy from which on orbits pass L2, which lies at about this distance from the smaller body.
double energy_of_l2(double mu, double distance) {
  const auto attraction = [](double mass, double r) { return mass / (r * r); };
  double r = distance;
  for (int round = 0; round < 30; ++round) {
    const double x = 1 - mu + r;
    const double force = x - attraction(1 - mu, 1 + r) - attraction(mu, r);
    const double slope = 1 + 2 * attraction(1 - mu, 1 + r) / (1 + r) + 2 * attraction(mu, r) / r;
    const double step = force / slope;
    r = std::max(r - step, 0.5 * r);
    if (std::fabs(step) < 1e-15) break;
  }
  const double x = 1 - mu + r;
  return -0.5 * x * x - (1 - mu) / (1 + r) - mu / r;
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
            if (values[0] == 0) {
              system.connection.reset();
              system.no_connection =
                  "without the smaller body (mu = 0) orbits are those of two bodies, which no "
                  "manifolds part";
            } else if (const Parameters wanted{values[0], values[1]}; wanted != own_parameters) {
              const auto map_of = [&](const Parameters& parameters) {
                return FlowOf<ThreeBody>(ThreeBody{parameters[0]}).section_map(*system.section, parameters[1], options);
              };
              const FollowedSaddle saddle = followed(map_of, wanted);
              if (saddle.point) {
                // The reversor exchanges the two directions.
                const Point u = saddle.point->directions[0];
                system.connection->from = system.connection->to = saddle.point->at;
                system.connection->u_direction = u;
                system.connection->s_direction = {u.x, -u.y};
              } else {
                system.connection.reset();
                const Parameters last = on_the_way(wanted, saddle.reached);
                system.no_connection =
                    "on the way there from its own parameters the saddle of its tangle is lost near mu = " +
                    format_rounded(last[0], 4) + ", energy = " + format_rounded(last[1], 4);
              }
            }
            if (const double open = energy_of_l2(values[0], hill); system.connection && values[1] > open) {
              system.connection->caution =
                  "at energies above " + format_rounded(open, 5) + " the bottleneck at (" + format_rounded(two, 3) +
                  ", 0) is open, and orbits that enter it tear the return map: energies below do";
            }
            return system;
          }};
}

}  // namespace lober::detail
