#include "cli/program/system_options.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "lober/error.hpp"
#include "lober/orbits.hpp"

namespace lober::cli {
namespace {

Point point_of(const std::vector<double>& numbers) {
  return {numbers[0], numbers[1]};
}

// Whether a guess means a point or one of its translates.
bool is_copy(Point guess, Point point, Point period) {
  const Point there = folded(guess, period, {point.x - 0.5 * period.x, point.y - 0.5 * period.y});
  return std::hypot(there.x - point.x, there.y - point.y) < 0.1 * std::hypot(period.x, period.y);
}

// To what the coordinates of saddles, which may have been computed, are rounded.
bool is_period_apart(const Connection& connection, Point period) {
  const double x = connection.to.x - connection.from.x - period.x, y = connection.to.y - connection.from.y - period.y;
  return !(period == Point{}) && std::hypot(x, y) <= 1e-9 * std::hypot(period.x, period.y);
}

}  // namespace

void add_system_option(OptionParser& parser, std::string& name, bool positional) {
  parser
      .add(positional ? "SYSTEM,--system" : "--system", name,
           "The name of a built-in system, or the path of a shared library (lober_system.h).")
      .required();
}

void add_parameter_option(OptionParser& parser, std::vector<std::string>& parameters) {
  parser
      .add("--param", parameters,
           "A parameter of the system and its value; the option may be repeated (default: the system's own values).")
      .value("NAME=VALUE");
}

void add_integration_option(OptionParser& parser, IntegrationOptions& integration) {
  parser
      .add("--integration-tolerance", integration.tolerance,
           "The error that one step of the integration of a flow may have, absolute and relative (default: 1e-12).")
      .positive()
      .value("T");
}

void add_system_options(OptionParser& parser, SystemRequest& request, bool positional) {
  const auto add_point = [&](const char* name, std::vector<double>& point, const char* meaning) {
    parser.add(name, point, meaning).comma_separated().count(2).value("X,Y");
  };
  add_system_option(parser, request.name, positional);
  add_parameter_option(parser, request.parameters);
  add_point("--from", request.from,
            "A point near the saddle of the unstable manifold, in the coordinates of the map (default: the system's).");
  add_point("--to", request.to,
            "A point near the saddle of the stable manifold, in the coordinates of the map (default: that of --from, "
            "a period of the plane farther where that is the system's own saddle and its tangle leads there, or the "
            "system's).");
  add_point("--u-direction", request.u_direction,
            "A vector roughly along the unstable manifold, away from its saddle (default: the system's).");
  add_point("--s-direction", request.s_direction,
            "A vector roughly along the stable manifold, away from its saddle (default: the system's).");
  add_point("--bip", request.bip,
            "A point near the boundary intersection point, the pip at which the boundary passes from U to S (default: "
            "the system's, or the middle pip).");
  add_integration_option(parser, request.integration);
}

std::vector<std::string> files_of_system(const std::string& name) {
  return is_library_path(name) ? std::vector{name} : std::vector<std::string>{};
}

bool is_system(const std::string& argument) {
  if (argument.ends_with(".so")) return true;
  const std::vector<SystemInfo> built_in = list_systems();
  return std::any_of(built_in.begin(), built_in.end(), [&](const SystemInfo& info) { return info.name == argument; }) &&
         !std::filesystem::exists(argument);
}

ParameterValues parameter_values(const std::vector<std::string>& texts) {
  ParameterValues values;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) throw UsageError("--param: \"" + text + "\" is not of the form NAME=VALUE");
    const std::optional<double> value = number_of(text.substr(equals + 1));
    if (!value) throw UsageError("--param NAME=VALUE: the value in \"" + text + "\" is not a number");
    values.emplace_back(text.substr(0, equals), *value);
  }
  return values;
}

System system_of(const SystemRequest& request, const ParameterValues& values) {
  System system = make_system(request.name, values, request.integration);
  if (!system.map) throw UsageError("system " + system.info.name + " has no planar map, which this command needs");
  return system;
}

Connection connection_of(const SystemRequest& request, const System& system) {
  const bool saddles_given = !request.from.empty() || !request.to.empty();
  if (!system.connection) {
    std::string missing;
    const auto need = [&](const std::vector<double>& vector, const char* option) {
      if (vector.empty()) missing += (missing.empty() ? "" : ", ") + std::string(option);
    };
    need(request.from, "--from");
    need(request.u_direction, "--u-direction");
    need(request.s_direction, "--s-direction");
    if (!missing.empty() && !system.no_connection.empty()) {
      throw UsageError("system " + system.info.name + " has no tangle of its own at these parameters: " +
                       system.no_connection + "; give other parameters, or " + missing);
    }
    if (!missing.empty()) {
      throw UsageError("system " + system.info.name + " does not name the saddles of a tangle; give " + missing);
    }
  }
  Connection connection = system.connection.value_or(Connection{});
  // A bip that belongs to other saddles is not one of these manifolds.
  if (saddles_given) {
    connection.bip.reset();
    connection.closure.clear();
  }
  if (!request.from.empty()) {
    // The system's own tangle may join a saddle to itself a period of the plane farther, which its directions fit;
    // other saddles are joined to themselves.
    const Point from = point_of(request.from), period = system.lattice;
    const bool own_directions = request.u_direction.empty() && request.s_direction.empty();
    const bool next_cell =
        own_directions && is_period_apart(connection, period) && is_copy(from, connection.from, period);
    connection.from = connection.to = from;
    if (next_cell) connection.to = {from.x + period.x, from.y + period.y};
  }
  if (!request.to.empty()) connection.to = point_of(request.to);
  if (!request.u_direction.empty()) connection.u_direction = point_of(request.u_direction);
  if (!request.s_direction.empty()) connection.s_direction = point_of(request.s_direction);
  if (!request.bip.empty()) connection.bip = point_of(request.bip);
  return connection;
}

std::string system_text(const System& system) {
  std::string text = system.info.name;
  const char* separator = "  ";
  for (const Parameter& parameter : system.info.parameters) {
    text += fmt::format("{}{} = {}", separator, parameter.name, parameter.value);
    separator = ", ";
  }
  return text;
}

Json system_json(const System& system, const IntegrationOptions& integration) {
  Json parameters = Json::object();
  for (const Parameter& parameter : system.info.parameters) parameters[parameter.name] = parameter.value;
  Json json{{"name", system.info.name}, {"parameters", std::move(parameters)}};
  if (system.flow) json["integration_tolerance"] = integration.tolerance;
  return json;
}

Json point_json(Point point) {
  return {point.x, point.y};
}

}  // namespace lober::cli
