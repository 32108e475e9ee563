// The table of `lober transport` for people.

#include <spdlog/fmt/fmt.h>

#include <cmath>

#include "cli/program/option_names.hpp"
#include "cli/report/agreement_report.hpp"
#include "cli/report/turnstile_report.hpp"
#include "cli/transport/transport_report.hpp"

namespace lober::cli {
namespace {

std::string format_value(double value) {
  return std::isnan(value) ? std::string("-") : fmt::format("{:.14g}", value);
}
std::string format_error(Measured value) {
  return std::isnan(value.value) || std::isnan(value.error) ? std::string("-") : fmt::format("{:.0e}", value.error);
}

std::string regions_text(std::span<const Region> regions) {
  std::string text;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    text += fmt::format("{:<11}R{}", i == 0 ? "regions" : "", i + 1);
    text += regions[i].bounded ? fmt::format(", area {:.15g} +- {:.1e}\n", regions[i].area.value, regions[i].area.error)
                               : std::string(", not bounded\n");
  }
  return text;
}

// Between the first two regions.
Table pair_table(bool particles) {
  Table table({{"n", 4, Align::right, 0},
               {"a12(n)", 18},
               {"a21(n)", 18},
               {"T12(n)", 18},
               {"T21(n)", 18},
               {"+- T", 8},
               {"T12 by boundaries", 18},
               {"+-", 8}});
  if (particles) {
    table.add({"by particles", 14});
    table.add({"+-", 8});
  }
  return table;
}

bool has_particles(const TransportStep& step) {
  return step.by_particles.size() > 0;
}

std::string steps_table(std::span<const TransportStep> steps) {
  std::string text = transport_rows_head(has_particles(steps.front()));
  for (const TransportStep& step : steps) text += transport_row(step);
  return text + transport_matrix(steps);
}

}  // namespace

// Between all of them, when there are more.
std::string transport_matrix(std::span<const TransportStep> steps) {
  const std::size_t regions = steps.front().total.size();
  if (regions < 3) return {};
  const auto pairs = [&](const auto& entry) {
    for (std::size_t i = 0; i < regions; ++i) {
      for (std::size_t j = 0; j < regions; ++j) {
        if (i != j) entry(i, j);
      }
    }
  };
  Table table({{"n", 4, Align::right, 0}});
  pairs([&](std::size_t i, std::size_t j) { table.add({fmt::format("T{}{}(n)", i + 1, j + 1), 18}); });
  table.add({"+- at most", 12});
  std::string text = "\n" + table.head();
  for (const TransportStep& step : steps) {
    Measured largest{0, 0};
    std::vector<std::string> cells{std::to_string(step.n)};
    pairs([&](std::size_t i, std::size_t j) {
      if (step.total(i, j).error > largest.error) largest = step.total(i, j);
      cells.push_back(format_value(step.total(i, j).value));
    });
    cells.push_back(format_error(largest));
    text += table.row(cells);
  }
  return text;
}

std::string transport_rows_head(bool particles) {
  return "\n" + pair_table(particles).head();
}

std::string transport_row(const TransportStep& step) {
  const Measured out = step.total(0, 1), boundaries = step.by_boundaries(0, 1);
  std::vector<std::string> cells{std::to_string(step.n),
                                 format_value(step.flux(0, 1).value),
                                 format_value(step.flux(1, 0).value),
                                 format_value(out.value),
                                 format_value(step.total(1, 0).value),
                                 format_error(out),
                                 format_value(boundaries.value),
                                 format_error(boundaries)};
  if (has_particles(step)) {
    const Measured counted = step.by_particles(0, 1);
    cells.push_back(fmt::format("{:.6g}", counted.value));
    cells.push_back(format_error(counted));
  }
  return pair_table(has_particles(step)).row(cells);
}

std::string transport_row_line(const TransportStep& step) {
  const Measured lobes = step.total(0, 1), boundaries = step.by_boundaries(0, 1);
  return fmt::format("n = {}: T12 {} +- {} by lobes, {} +- {} by boundaries\n", step.n, format_value(lobes.value),
                     format_error(lobes), format_value(boundaries.value), format_error(boundaries));
}

std::string interrupted_transport_table(std::span<const TransportStep> steps, const Agreement& agreement,
                                        int iterates) {
  return agreement_text(agreement) + steps_table(steps) + transport_interruption(steps.size(), iterates);
}

std::string transport_interruption(std::size_t rows, int iterates) {
  return fmt::format("n = 1 to {} of {}: interrupted\n", rows, iterates);
}

std::string transport_heading(const TransportReport& report) {
  const operations::SystemTransport& result = report.result();
  std::string text;
  for (const TransportBoundary& boundary : result.boundaries) {
    text += saddles_text(*boundary.manifolds) + turnstile_text(*boundary.manifolds) + "\n";
  }
  if (result.melnikov) text += melnikov_text(*result.melnikov) + "\n";
  return text + regions_text(result.regions);
}

std::string transport_remarks(const TransportReport& report) {
  std::string text;
  for (const std::string& remark : report.result().remarks) text += with_option_names(remark) + "\n";
  return text;
}

std::string transport_table(const TransportReport& report) {
  const operations::SystemTransport& result = report.result();
  return agreement_text(result.agreement) + system_text(report.system) + "\n" + transport_heading(report) +
         steps_table(result.steps) + transport_remarks(report);
}

std::string transport_table(const CurvesTransportReport& report) {
  const auto& result = report.outcome.as<operations::CurveTransport>();
  std::string text = agreement_text(result.agreement);
  text += fmt::format("turnstile  {} a period; L12(1) {:.15g} +- {:.1e}, L21(1) {:.15g} +- {:.1e}\n",
                      counted(result.period, "lobe", "lobes"), result.flux12.value, result.flux12.error,
                      result.flux21.value, result.flux21.error);
  text += regions_text(result.regions);
  text += result.steps.empty() ? std::string("no row: the curves do not reach f(q)\n") : steps_table(result.steps);
  if (!result.why.empty()) text += with_option_names(result.why) + "\n";
  return text;
}

}  // namespace lober::cli
