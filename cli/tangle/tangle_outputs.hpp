// Outputs of both forms of `lober tangle` (manifolds from files, manifolds grown from equations).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/program/command_line.hpp"
#include "cli/tangle/tangle_report.hpp"

namespace lober::cli {

struct TangleOutputs {
  std::string lobes, boundary, pips, graph, json, html, format;
  PictureRequest picture;

  /// Adds --lobes, --boundary, --pips, --json, --html, --format and the options of pictures.
  void add_options(OptionParser& parser);
  /// The files that were asked for.
  [[nodiscard]] std::vector<Output> files() const;
};

/// Writes the files; `seconds_so_far` gives the time since the program began.
void write_tangle(const TangleOutputs& outputs, TangleReport& report, const std::function<double()>& seconds_so_far);

/// Prints the table, unless standard output is one of the files.
void print_tangle(const TangleOutputs& outputs, const TangleReport& report);

}  // namespace lober::cli
