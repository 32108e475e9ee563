#include "cli/systems/systems_command.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "cli/picture/picture_options.hpp"
#include "cli/program/command_line.hpp"
#include "cli/program/option_parser.hpp"
#include "cli/program/system_options.hpp"
#include "cli/report/json_file.hpp"
#include "cli/report/table.hpp"
#include "cli/systems/system_portrait.hpp"
#include "lober/dynamics/fixed_points.hpp"
#include "lober/dynamics/systems.hpp"

namespace lober::cli {
namespace {

std::string text_of(Point point) {
  return fmt::format("({:.10g}, {:.10g})", point.x, point.y);
}

// The commands that take a system.
std::vector<std::string> commands_for(const System& system) {
  std::vector<std::string> commands;
  if (system.map) commands.insert(commands.end(), {"grow", "image", "fixed-points", "section"});
  if (system.map && system.connection) {
    commands.emplace_back("tangle");
    commands.emplace_back("transport");
  }
  if (system.flow && system.section && !system.saddles.empty()) commands.emplace_back("escape");
  return commands;
}

// A linear form of x and y with small coefficients: "2 - x".
std::string linear_form_text(double of_x, double of_y, double constant) {
  std::string text = constant == 0 ? "" : fmt::format("{:.10g}", constant);
  const auto add = [&](double coefficient, const char* name) {
    if (coefficient == 0) return;
    text += coefficient < 0 ? text.empty() ? "-" : " - " : text.empty() ? "" : " + ";
    if (std::fabs(coefficient) != 1) text += fmt::format("{:.10g} ", std::fabs(coefficient));
    text += name;
  };
  add(of_x, "x");
  add(of_y, "y");
  return text.empty() ? "0" : text;
}

std::string symmetry_text(const Symmetry& symmetry) {
  return fmt::format("(x, y) -> ({}, {}) {}",
                     linear_form_text(symmetry.linear.xx, symmetry.linear.xy, symmetry.shift.x),
                     linear_form_text(symmetry.linear.yx, symmetry.linear.yy, symmetry.shift.y),
                     symmetry.reversor ? "turns the map into its inverse" : "commutes with the map");
}

std::string list_text(std::span<const SystemInfo> infos) {
  std::size_t width = 0;
  for (const SystemInfo& info : infos) width = std::max(width, info.name.size());
  const Table table({{"system", width, Align::left, 0}, {"equations, and the map", 0, Align::left, 2}});
  std::string text = table_format() == TableFormat::markdown ? table.head() : "";
  for (const SystemInfo& info : infos) text += table.row({info.name, info.summary});
  return text + "`lober systems NAME` lists the parameters of one; a name with a slash or .so is a shared library.\n";
}

// "; positive", "; in [0, 0.5]"; "; any number" where there is no bound.
std::string range_text(const Parameter& parameter) {
  const std::string range = parameter.range();
  return "; " + (range.empty() ? "any number" : range) + (parameter.perturbation ? "; size of the perturbation" : "");
}

// The fixed points in the window; none where the system has no map or no such point.
std::vector<FixedPoint> fixed_points_of(const System& system) {
  if (!system.map || !(system.window.width() > 0 && system.window.height() > 0)) return {};
  FixedPointOptions options;
  options.max_work = 1e7;  // an overview, which is not waited for
  return search_fixed_points(*system.map, system.window, options, options.grid).points;
}

std::string details_text(const System& system, std::span<const FixedPoint> points) {
  std::string text = system.info.name + "  " + system.info.summary + "\n";
  const Table parameters(
      {{"parameter", 8, Align::left, 2}, {"value", 18, Align::left}, {"meaning and range", 0, Align::left}});
  if (table_format() == TableFormat::markdown && !system.info.parameters.empty()) text += parameters.head();
  for (const Parameter& parameter : system.info.parameters) {
    text +=
        parameters.row({parameter.name, fmt::format("{}", parameter.value), parameter.meaning + range_text(parameter)});
  }
  text += fmt::format("kind       {}\n", system.flow ? system.map ? "flow, with a planar map" : "flow" : "map");
  const Rectangle& window = system.window;
  if (system.map) {
    text += fmt::format("window     [{:.10g}, {:.10g}] x [{:.10g}, {:.10g}]\n", window.min_x, window.max_x,
                        window.min_y, window.max_y);
  }
  if (!(system.lattice == Point{})) text += "repeats    after a shift by " + text_of(system.lattice) + "\n";
  if (!(system.second_lattice == Point{})) {
    text += "repeats    after a shift by " + text_of(system.second_lattice) + "\n";
  }
  std::vector<Connection> connections = system.further;
  if (system.connection) connections.insert(connections.begin(), *system.connection);
  for (const Connection& connection : connections) {
    text += fmt::format("manifolds  U of {} along {}, S of {} along {}{}\n", text_of(connection.from),
                        text_of(connection.u_direction), text_of(connection.to), text_of(connection.s_direction),
                        connection.bip ? ", bip near " + text_of(*connection.bip) : "");
  }
  for (const FixedPoint& point : points) {
    text += fmt::format("point      {} {}, residue {:.6g}\n", text_of(point.at), name(point.kind), residue(point));
  }
  if (!system.no_connection.empty()) text += "manifolds  none: " + system.no_connection + "\n";
  for (const Symmetry& symmetry : system.symmetries) text += "symmetry   " + symmetry_text(symmetry) + "\n";
  for (const FlowState& saddle : system.saddles) {
    text +=
        fmt::format("saddle     ({:.10g}, {:.10g}, {:.10g}, {:.10g})\n", saddle[0], saddle[1], saddle[2], saddle[3]);
  }
  text += fmt::format("commands   {}\n", fmt::join(commands_for(system), ", "));
  return text;
}

Json parameters_json(const SystemInfo& info) {
  Json list = Json::array();
  for (const Parameter& parameter : info.parameters) {
    list.push_back({{"name", parameter.name},
                    {"value", parameter.value},
                    {"meaning", parameter.meaning},
                    {"min", number_json(parameter.min)},
                    {"max", number_json(parameter.max)},
                    {"min_excluded", parameter.min_excluded},
                    {"max_excluded", parameter.max_excluded},
                    {"perturbation", parameter.perturbation}});
  }
  return list;
}

Json info_json(const SystemInfo& info) {
  return {{"name", info.name}, {"summary", info.summary}, {"parameters", parameters_json(info)}};
}

Json details_json(const System& system, std::span<const FixedPoint> points) {
  Json json = info_json(system.info);
  json["flow"] = system.flow != nullptr;
  json["map"] = system.map != nullptr;
  json["window"] = {system.window.min_x, system.window.min_y, system.window.max_x, system.window.max_y};
  json["picture"] = {system.picture.min_x, system.picture.min_y, system.picture.max_x, system.picture.max_y};
  json["lattice"] = point_json(system.lattice);
  json["second_lattice"] = point_json(system.second_lattice);
  Json connections = Json::array();
  const auto add = [&](const Connection& connection) {
    Json one{{"from", point_json(connection.from)},
             {"u_direction", point_json(connection.u_direction)},
             {"to", point_json(connection.to)},
             {"s_direction", point_json(connection.s_direction)}};
    one["bip_near"] = connection.bip ? point_json(*connection.bip) : Json();
    connections.push_back(std::move(one));
  };
  if (system.connection) add(*system.connection);
  std::for_each(system.further.begin(), system.further.end(), add);
  json["connections"] = std::move(connections);
  json["no_connection"] = system.no_connection.empty() ? Json() : Json(system.no_connection);
  Json saddles = Json::array();
  for (const FlowState& saddle : system.saddles) saddles.push_back(saddle);
  json["saddles"] = std::move(saddles);
  Json fixed_points = Json::array();
  for (const FixedPoint& point : points) {
    fixed_points.push_back({{"at", point_json(point.at)}, {"type", name(point.kind)}, {"residue", residue(point)}});
  }
  json["fixed_points"] = std::move(fixed_points);
  Json symmetries = Json::array();
  for (const Symmetry& symmetry : system.symmetries) {
    const Matrix2& linear = symmetry.linear;
    symmetries.push_back({{"linear", {{linear.xx, linear.xy}, {linear.yx, linear.yy}}},
                          {"shift", point_json(symmetry.shift)},
                          {"reversor", symmetry.reversor}});
  }
  json["symmetries"] = std::move(symmetries);
  json["commands"] = commands_for(system);
  return json;
}

}  // namespace

void run_systems(const std::vector<std::string>& arguments) {
  SystemRequest request;
  std::string json_path;
  PictureRequest picture;
  OptionParser parser(
      "Lists the built-in systems; with a name, shows the equations, parameters, fixed points, saddles and manifolds "
      "of "
      "that system.",
      "lober systems");
  parser.add_example("lober systems", "the names of all systems");
  parser.add_example("lober systems ovp --param gamma=0.5", "the equations, parameters and manifolds of one");
  parser.add_example("lober systems duffing --picture duffing.svg", "its phase portrait");
  parser.add("SYSTEM", request.name, "The name of a system, or a shared library (lober_system.h).");
  add_parameter_option(parser, request.parameters);
  add_picture_options(parser, picture, "orbits, fixed points and manifolds of SYSTEM",
                      "fixed points by their residues");
  add_json_option(parser, json_path, "the list");
  add_table_option(parser);
  if (!parser.parse(arguments)) return;
  const std::vector<Output> outputs =
      checked_outputs({{"--json", json_path}}, files_of_system(request.name), picture.outputs());
  std::string text;
  Json json;
  if (request.name.empty()) {
    if (!request.parameters.empty()) throw UsageError("--param needs the name of a system");
    if (picture.asked()) throw UsageError("--picture and --data need the name of a system");
    const std::vector<SystemInfo> infos = list_systems();
    text = list_text(infos);
    json = Json::array();
    for (const SystemInfo& info : infos) json.push_back(info_json(info));
  } else {
    const System system = make_system(request.name, parameter_values(request.parameters));
    const std::vector<FixedPoint> points = fixed_points_of(system);
    text = details_text(system, points);
    json = details_json(system, points);
    if (picture.asked()) write_figure(picture, system_portrait(system, points, picture.labels_for(points.size())));
  }
  if (!json_path.empty()) write_listing(json_path, "systems", "systems", std::move(json));
  if (!takes_standard_output(outputs)) print_report(text);
}

}  // namespace lober::cli
