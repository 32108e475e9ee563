// Everything that `lober transport` found, for the table, the JSON and the pictures to show.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cli/picture/picture_options.hpp"
#include "cli/program/system_options.hpp"
#include "cli/report/report.hpp"
#include "lober/curve/curve.hpp"
#include "lober/curve/files.hpp"
#include "lober/operations.hpp"

namespace lober::cli {

struct TransportReport {
  System system;
  operations::Outcome outcome;
  struct {
    double transport = 0, write = 0;  ///< seconds
  } timing;

  [[nodiscard]] const operations::SystemTransport& result() const { return outcome.as<operations::SystemTransport>(); }
  [[nodiscard]] const ManifoldTangle& manifolds() const { return result().manifolds(); }
  [[nodiscard]] const Tangle& tangle() const { return result().manifolds().tangle; }
};

/// The report of transport from two curves of files.
struct CurvesTransportReport {
  std::array<NamedCurve, 2> inputs;
  operations::Outcome outcome;
};

/// The short aligned table for people.
[[nodiscard]] std::string transport_table(const TransportReport& report);
[[nodiscard]] std::string transport_table(const CurvesTransportReport& report);

// Its parts, for a terminal, where the rows come first, as they are ready.
/// Manifolds, turnstiles and regions.
[[nodiscard]] std::string transport_heading(const TransportReport& report);
/// The rows between the first two regions.
[[nodiscard]] std::string transport_rows_head(bool particles);
[[nodiscard]] std::string transport_row(const TransportStep& step);
/// One line for a row that is ready before the table, for a terminal that the table does not go to.
[[nodiscard]] std::string transport_row_line(const TransportStep& step);
[[nodiscard]] std::string transport_interruption(std::size_t rows, int iterates);
/// T between all regions, where there are more than two.
[[nodiscard]] std::string transport_matrix(std::span<const TransportStep> steps);
[[nodiscard]] std::string transport_remarks(const TransportReport& report);

/// The table when the command is interrupted: at least one row.
[[nodiscard]] std::string interrupted_transport_table(std::span<const TransportStep> steps, const Agreement& agreement,
                                                      int iterates);

/// Areas by Melnikov's function, beside the exact ones.
[[nodiscard]] std::string melnikov_text(const operations::MelnikovComparison& report);

/// a(n) and T(n) over n, with error bars, by all routes; `normalised`: divided by a(1).
[[nodiscard]] Figure fluxes_figure(const TransportReport& report, bool normalised);
/// Manifolds, boundary, turnstile, its images and pre-images and their common parts; of further boundaries the
/// turnstile alone. Borrows the manifolds.
[[nodiscard]] Figure turnstile_figure(const TransportReport& report, const PictureRequest& how);
/// The window of a plot of values over a variable: with a margin, but not below 0 where all are positive.
[[nodiscard]] Rectangle widened_plot(const Rectangle& box);

}  // namespace lober::cli
