#include "engine/operations/connection_choice.hpp"

#include <algorithm>
#include <cmath>

#include "engine/base/quantities.hpp"
#include "lober/base/error.hpp"
#include "lober/dynamics/orbits.hpp"

namespace lober::detail::table {
using namespace operations;
namespace {

// Whether a guess means a point or one of its translates.
bool is_copy(Point guess, Point point, Point period) {
  const Point there = folded(guess, period, {point.x - 0.5 * period.x, point.y - 0.5 * period.y});
  return std::hypot(there.x - point.x, there.y - point.y) < 0.1 * std::hypot(period.x, period.y);
}

// Whether the saddles are a period apart, as far as their coordinates, which may have been computed, are rounded.
bool is_period_apart(const Connection& connection, Point period) {
  const double x = connection.to.x - connection.from.x - period.x, y = connection.to.y - connection.from.y - period.y;
  return !(period == Point{}) && std::hypot(x, y) <= 1e-9 * std::hypot(period.x, period.y);
}

void require_complete(const ConnectionChoice& choice, const System& system) {
  std::string missing;
  const auto need = [&](const std::optional<Point>& vector, const char* option) {
    if (!vector) missing += (missing.empty() ? "option \"" : ", option \"") + std::string(option) + "\"";
  };
  need(choice.from, "from");
  need(choice.u_direction, "u_direction");
  need(choice.s_direction, "s_direction");
  if (missing.empty()) return;
  if (!system.no_connection.empty()) {
    throw UsageError("system " + system.info.name + " has no tangle of its own at these parameters: " +
                     system.no_connection + "; give other parameters, or " + missing);
  }
  throw UsageError("system " + system.info.name + " does not name the saddles of a tangle; give " + missing +
                   ", with saddles that " + std::string(quantity::search) + " finds");
}

}  // namespace

const OptionList<ConnectionChoice>& connection_options() {
  static const OptionList<ConnectionChoice> options = [] {
    using Choice = ConnectionChoice;
    OptionList<Choice> list;
    list.option("from", &Choice::from, "point near the saddle of the unstable manifold, in the coordinates of the map",
                {.otherwise = "the system's"})
        .option(
            "to", &Choice::to, "point near the saddle of the stable manifold, in the coordinates of the map",
            {.otherwise = "that of from, a period of the plane farther where that is the system's own saddle and its "
                          "tangle leads there, or the system's"})
        .option("u_direction", &Choice::u_direction, "vector roughly along the unstable manifold, away from its saddle",
                {.otherwise = "the system's"})
        .option("s_direction", &Choice::s_direction, "vector roughly along the stable manifold, away from its saddle",
                {.otherwise = "the system's"})
        .option("bip", &Choice::bip,
                "point near the boundary intersection point, the pip at which the boundary passes from U to S",
                {.otherwise = "the system's, or the pip halfway, up to which U is as long as S"});
    return list;
  }();
  return options;
}

Connection chosen_connection(const ConnectionChoice& choice, const System& system) {
  const auto not_zero = [](const std::optional<Point>& direction, const char* option) {
    if (direction && *direction == Point{}) {
      throw UsageError("option \"" + std::string(option) + "\": a direction cannot be the vector 0, 0");
    }
  };
  not_zero(choice.u_direction, "u_direction");
  not_zero(choice.s_direction, "s_direction");
  if (!system.connection) require_complete(choice, system);
  Connection connection = system.connection.value_or(Connection{});
  // A bip that belongs to other saddles is not one of these manifolds.
  if (choice.from || choice.to) {
    connection.bip.reset();
    connection.closure.clear();
  }
  if (choice.from) {
    // The system's own tangle may join a saddle to itself a period of the plane farther, which its directions fit;
    // other saddles are joined to themselves.
    const Point from = *choice.from, period = system.lattice;
    const bool own_directions = !choice.u_direction && !choice.s_direction;
    const bool next_cell =
        own_directions && is_period_apart(connection, period) && is_copy(from, connection.from, period);
    connection.from = connection.to = from;
    if (next_cell) connection.to = {from.x + period.x, from.y + period.y};
  }
  if (choice.to) connection.to = *choice.to;
  if (choice.u_direction) connection.u_direction = *choice.u_direction;
  if (choice.s_direction) connection.s_direction = *choice.s_direction;
  if (choice.bip) connection.bip = *choice.bip;
  return connection;
}

std::vector<Connection> further_of(const ConnectionChoice& choice, const System& system, bool wanted) {
  if (!choice.is_own() || !(wanted || system.further_needed)) return {};
  return system.further;
}

std::vector<OptionSetting> settings_of(const Connection& connection) {
  std::vector<OptionSetting> settings{{"from", connection.from},
                                      {"to", connection.to},
                                      {"u_direction", connection.u_direction},
                                      {"s_direction", connection.s_direction}};
  if (connection.bip) settings.push_back({"bip", *connection.bip});
  return settings;
}

}  // namespace lober::detail::table
