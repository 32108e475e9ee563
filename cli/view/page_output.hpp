// Pages of results: --html FILE of the commands.
#pragma once

#include <string>

#include "cli/program/curves_run.hpp"
#include "cli/program/option_parser.hpp"
#include "cli/tangle/tangle_report.hpp"

namespace lober::cli {

/// --html FILE.
Option add_html_option(OptionParser& parser, std::string& path);

/// Writes the page of an overlay, or of regions where a fill rule was given.
void write_page(const std::string& path, const CurvesReport& report);
/// Writes the page of a tangle.
void write_page(const std::string& path, const TangleReport& report);

}  // namespace lober::cli
