// The findings of `lober transport --sweep`, for the table, the JSON and the curve to show.
#pragma once

#include <string>

#include "cli/picture/figure.hpp"
#include "lober/operations.hpp"

namespace lober::cli {

struct SweepReport {
  SystemInfo system;  ///< as it was given: the parameter that is varied has any value
  operations::Outcome outcome;

  [[nodiscard]] const operations::SystemSweep& result() const { return outcome.as<operations::SystemSweep>(); }
};

/// The table for people; and its parts, for rows that are printed as they are ready.
[[nodiscard]] std::string sweep_table(const SweepReport& report);
/// The system, and the names of the columns.
[[nodiscard]] std::string sweep_head(const SystemInfo& system, const operations::SystemSweep& sweep);
[[nodiscard]] std::string sweep_row(const operations::SystemSweep& sweep, std::size_t k);
/// The lines behind the rows.
[[nodiscard]] std::string sweep_summary(const SweepReport& report);

/// The areas over the parameter; vertical lines where the difference changes its sign.
[[nodiscard]] Figure sweep_figure(const SweepReport& report);

}  // namespace lober::cli
