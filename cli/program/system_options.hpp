// A system, its parameters and the pair of manifolds, as the command line gives them.
#pragma once

#include <string>
#include <vector>

#include "cli/program/option_parser.hpp"
#include "cli/report/json.hpp"
#include "lober/dynamics/systems.hpp"
#include "lober/operations.hpp"

namespace lober::cli {

struct SystemRequest {
  std::string name;
  std::vector<std::string> parameters;  ///< NAME=VALUE
  IntegrationOptions integration;
};

/// SYSTEM, as an argument or by --system, which `positional` decides.
void add_system_option(OptionParser& parser, std::string& name, bool positional);
/// --param NAME=VALUE, for parameter_values.
void add_parameter_option(OptionParser& parser, std::vector<std::string>& parameters);
/// --integration-tolerance T.
void add_integration_option(OptionParser& parser, IntegrationOptions& integration);

/// Whether a system of the program has this name.
[[nodiscard]] bool is_built_in(const std::string& name);
/// Whether an argument that could name a file names a system: a built-in one, no file being called that, or a
/// library (.so).
[[nodiscard]] bool is_system(const std::string& argument);
/// The files that the name of a system stands for, which no output may replace: a shared library, or none.
[[nodiscard]] std::vector<std::string> files_of_system(const std::string& name);

/// Throws UsageError for a text that is not NAME=VALUE.
[[nodiscard]] ParameterValues parameter_values(const std::vector<std::string>& texts);

/// The system as operations take it. Throws UsageError.
[[nodiscard]] operations::SystemInput system_input_of(const SystemRequest& request);

/// "ovp  gamma = 0.5, eps = 0.1".
[[nodiscard]] std::string system_text(const System& system);
/// The same for files of results, with the path and the SHA-256 of the library of a system of one's own.
[[nodiscard]] std::string system_note(const System& system);
/// name, parameters, library (file and sha256) of a system of one's own, and integration_tolerance of a flow.
[[nodiscard]] Json system_json(const System& system, const IntegrationOptions& integration);
[[nodiscard]] Json point_json(Point point);

}  // namespace lober::cli
