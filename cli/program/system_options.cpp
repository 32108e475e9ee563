#include "cli/program/system_options.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <filesystem>

#include "lober/base/error.hpp"

namespace lober::cli {

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

std::vector<std::string> files_of_system(const std::string& name) {
  return is_library_path(name) ? std::vector{name} : std::vector<std::string>{};
}

bool is_built_in(const std::string& name) {
  const std::vector<SystemInfo> built_in = list_systems();
  return std::any_of(built_in.begin(), built_in.end(), [&](const SystemInfo& info) { return info.name == name; });
}

bool is_system(const std::string& argument) {
  return argument.ends_with(".so") || (is_built_in(argument) && !std::filesystem::exists(argument));
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

operations::SystemInput system_input_of(const SystemRequest& request) {
  return operations::system_input(request.name, parameter_values(request.parameters), request.integration);
}

std::string system_note(const System& system) {
  const SystemInfo& info = system.info;
  return system_text(system) + (info.library.empty() ? "" : "  of " + info.library + " sha256 " + info.library_sha256);
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
  if (!system.info.library.empty()) {
    json["library"] = {{"file", system.info.library}, {"sha256", system.info.library_sha256}};
  }
  if (system.flow) json["integration_tolerance"] = integration.tolerance;
  return json;
}

Json point_json(Point point) {
  return {point.x, point.y};
}

}  // namespace lober::cli
