// What `lober transport --sweep` found, for the table, the JSON and the curve to show.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/program/system_options.hpp"
#include "lober/sweep.hpp"

namespace lober::cli {

struct SweepRange {
  std::string name;
  std::vector<double> values;
  bool reaches = true;  ///< false where the step is longer than the range, so that there is one value
};
/// NAME=FIRST:LAST:STEP; LAST is among the values if a whole number of steps leads there, to rounding. Throws
/// UsageError.
[[nodiscard]] SweepRange sweep_range(const std::string& text);

struct SweepReport {
  System system;  ///< for the first value
  IntegrationOptions integration;
  double tolerance = 0;
  bool find_zeros = false;
  SweepRange range;
  Sweep result;
  /// Of each row, when asked for: the area of the lobes of one side to first order in eps; NaN where it has none.
  std::optional<std::vector<double>> first_order{};
};

[[nodiscard]] std::string sweep_table(const SweepReport& report);
void write_sweep_json(const std::string& path, const SweepReport& report,
                      const std::function<double()>& seconds_so_far);
void write_sweep_curve(const std::string& path, const SweepReport& report);

}  // namespace lober::cli
