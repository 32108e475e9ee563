// Pages of results: --html FILE of the commands.
#pragma once

#include <string>
#include <vector>

#include "cli/escape/escape_report.hpp"
#include "cli/program/curves_run.hpp"
#include "cli/program/option_parser.hpp"
#include "cli/tangle/tangle_report.hpp"
#include "cli/transport/transport_report.hpp"

namespace lober::cli {

/// --html FILE.
Option add_html_option(OptionParser& parser, std::string& path);

/// Writes the page of an overlay, or of regions where a fill rule was given.
void write_page(const std::string& path, const CurvesReport& report);
/// Writes the page of a tangle.
void write_page(const std::string& path, const TangleReport& report);
/// Writes the page of transport: its tangle, and the areas that cross.
void write_page(const std::string& path, const TransportReport& report);
/// Writes the page of the tubes of an escape.
void write_page(const std::string& path, const EscapeReport& report);
/// Writes the page of a manifold that was grown.
void write_page(const std::string& path, const System& system, const operations::Outcome& grown);

/// Whether an operation on curves that is a command by itself has a page: regions and curve_transport.
[[nodiscard]] bool has_page(const operations::Operation& operation);
/// Writes its page. The tangle of transport is computed once more, as the result has areas only.
void write_page(const std::string& path, const std::string& command, const operations::Operation& operation,
                const operations::Outcome& outcome, const std::vector<operations::Input>& inputs,
                const std::vector<std::string>& notes);

}  // namespace lober::cli
