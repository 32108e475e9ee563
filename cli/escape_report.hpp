// What `lober escape` has found, and how it is shown.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/dynamics/system.hpp"
#include "engine/escape/monte_carlo.hpp"

namespace lober::cli {

struct EscapeReport {
  SystemInfo system;  ///< with the values chosen
  EscapeOptions options;
  Escape result;  ///< without table when no crossings were asked for
  std::optional<MonteCarlo> check;
  MonteCarloOptions check_options;
  double escape_seconds = 0, check_seconds = 0;
};

/// "left" and "right" when there is one bottleneck on either side of the section, else "1", "2", ...
[[nodiscard]] std::vector<std::string> bottleneck_names(const Escape& result);

/// The table of the paper, exit by exit: one line a crossing, one column an entrance.
[[nodiscard]] std::string escape_table(const EscapeReport& report);

/// `seconds_so_far` is asked last, for the member `timing`.
void write_escape_json(const std::string& path, const EscapeReport& report,
                       const std::function<double()>& seconds_so_far);

/// The curves on the section in its direction, with what they have in common filled.
void write_escape_picture(const std::string& path, const EscapeReport& report);

}  // namespace lober::cli
