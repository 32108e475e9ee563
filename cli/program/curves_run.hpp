// Commands that run an operation of the table on two closed curves.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/program/option_parser.hpp"
#include "cli/program/progress.hpp"
#include "cli/report/json.hpp"
#include "engine/base/output_file.hpp"
#include "lober/curve/files.hpp"
#include "lober/operations.hpp"

namespace lober::cli {

/// The curves that were read, and the result of the operation.
struct CurvesReport {
  std::array<NamedCurve, 2> inputs;
  std::array<std::string, 2> specs;  ///< names of the curves on the command line
  Periods periods;
  operations::Outcome outcome;
  double read_seconds = 0, index_seconds = 0, write_seconds = 0;
};

/// Reads the curves and runs the operation. Throws DataError for curves that cannot be used; for one that is not simple
/// it names the file and the option --rule.
[[nodiscard]] CurvesReport run_on_curves(const std::string& operation, const std::array<std::string, 2>& curves,
                                         const std::vector<operations::OptionSetting>& settings, Periods periods,
                                         Progress& progress);

/// Warns of curves whose longitudes are counted differently (longitudes_warning), unless there is a period, or one of
/// them jumps, which its remark says.
void warn_of_longitudes(const NamedCurve& first, const NamedCurve& second, Periods periods);

/// Writes the JSON object of a command. `engine` are the engine's parts of the timing.
void write_curves_json(const std::string& path, std::string_view command, const std::string& operation,
                       CurvesReport& report, const std::array<double, 2>& areas,
                       const std::array<Orientation, 2>& orientations, const Json& engine,
                       const std::function<double()>& seconds_so_far,
                       const std::function<void(detail::OutputFile&)>& more = {});

/// --rule RULE, which runs the operation regions instead.
Option add_rule_option(OptionParser& parser, std::string& rule);

}  // namespace lober::cli
