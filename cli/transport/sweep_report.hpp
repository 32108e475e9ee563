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

[[nodiscard]] std::string sweep_table(const SweepReport& report);
/// The areas over the parameter; vertical lines where the difference changes its sign.
[[nodiscard]] Figure sweep_figure(const SweepReport& report);

}  // namespace lober::cli
