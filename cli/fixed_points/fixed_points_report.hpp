// Everything that `lober fixed-points` found, for the table and the CSV to show.
#pragma once

#include <string>

#include "cli/picture/figure.hpp"
#include "cli/picture/picture_options.hpp"
#include "lober/operations.hpp"

namespace lober::cli {

struct FixedPointsReport {
  System system;
  bool budget_given = false;
  operations::Outcome outcome;

  [[nodiscard]] const operations::SystemFixedPoints& result() const {
    return outcome.as<operations::SystemFixedPoints>();
  }
};

[[nodiscard]] std::string fixed_points_table(const FixedPointsReport& report);
/// A row for each point.
void write_fixed_points_csv(const std::string& path, const FixedPointsReport& report);
/// The points in the box that was searched.
[[nodiscard]] Figure fixed_points_figure(const FixedPointsReport& report, const PictureRequest& how);

}  // namespace lober::cli
