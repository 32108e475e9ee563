// Everything that `lober fixed-points` found, for the table, the JSON and the CSV to show.
#pragma once

#include <functional>
#include <string>

#include "lober/fixed_points.hpp"
#include "lober/systems.hpp"

namespace lober::cli {

struct FixedPointsReport {
  System system;
  IntegrationOptions integration;
  Rectangle box;
  FixedPointOptions options;
  int turns = 0;  ///< shifts of the system's lattice in options.shift
  int max_grid = 0;
  FixedPointSearch search;
  double search_seconds = 0;
};

[[nodiscard]] std::string fixed_points_table(const FixedPointsReport& report);
/// A row for each point.
void write_fixed_points_csv(const std::string& path, const FixedPointsReport& report);
/// Writes the JSON object (docs/conventions.md, section 13); `seconds_so_far` gives the time since the program began.
void write_fixed_points_json(const std::string& path, const FixedPointsReport& report,
                             const std::function<double()>& seconds_so_far);

}  // namespace lober::cli
