// The findings with --rule, for closed curves that may cross themselves (lober/regions.hpp).
#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>

#include "cli/program/curves_run.hpp"

namespace lober::cli {

/// The short aligned table for people.
[[nodiscard]] std::string regions_table(const CurvesReport& report);
/// The JSON object of a command (docs/conventions.md, section 13).
void write_regions_json(const std::string& path, std::string_view command, CurvesReport& report,
                        const std::function<double()>& seconds_so_far);
/// The seconds of parts, for --verbose.
void report_regions_timing(const CurvesReport& report);

}  // namespace lober::cli
