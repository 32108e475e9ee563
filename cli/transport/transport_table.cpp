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
std::string pair_text(std::span<const TransportStep> steps) {
  const bool particles = steps.front().by_particles.size() > 0;
  std::string text = fmt::format("\n{:>4} {:>18} {:>18} {:>18} {:>18} {:>8} {:>18} {:>8}", "n", "a12(n)", "a21(n)",
                                 "T12(n)", "T21(n)", "+- T", "T12 by boundaries", "+-");
  text += particles ? fmt::format(" {:>14} {:>8}\n", "by particles", "+-") : "\n";
  for (const TransportStep& step : steps) {
    const Measured out = step.total(0, 1), boundaries = step.by_boundaries(0, 1);
    text +=
        fmt::format("{:>4} {:>18} {:>18} {:>18} {:>18} {:>8} {:>18} {:>8}", step.n, format_value(step.flux(0, 1).value),
                    format_value(step.flux(1, 0).value), format_value(out.value), format_value(step.total(1, 0).value),
                    format_error(out), format_value(boundaries.value), format_error(boundaries));
    if (particles) {
      const Measured counted = step.by_particles(0, 1);
      text += fmt::format(" {:>14.6g} {:>8}", counted.value, format_error(counted));
    }
    text += "\n";
  }
  return text;
}

// Between all of them, when there are more.
std::string matrix_text(std::span<const TransportStep> steps) {
  const std::size_t regions = steps.front().total.size();
  if (regions < 3) return {};
  const auto pairs = [&](const auto& entry) {
    std::string text;
    for (std::size_t i = 0; i < regions; ++i) {
      for (std::size_t j = 0; j < regions; ++j) {
        if (i != j) text += entry(i, j);
      }
    }
    return text;
  };
  std::string text = fmt::format("\n{:>4}", "n") + pairs([](std::size_t i, std::size_t j) {
                       return fmt::format(" {:>18}", fmt::format("T{}{}(n)", i + 1, j + 1));
                     });
  text += fmt::format(" {:>12}\n", "+- at most");
  for (const TransportStep& step : steps) {
    Measured largest{0, 0};
    text += fmt::format("{:>4}", step.n) + pairs([&](std::size_t i, std::size_t j) {
              if (step.total(i, j).error > largest.error) largest = step.total(i, j);
              return fmt::format(" {:>18}", format_value(step.total(i, j).value));
            });
    text += fmt::format(" {:>12}\n", format_error(largest));
  }
  return text;
}

}  // namespace

std::string transport_steps_table(std::span<const TransportStep> steps) {
  return pair_text(steps) + matrix_text(steps);
}

std::string transport_row_text(const TransportStep& step) {
  const Measured lobes = step.total(0, 1), boundaries = step.by_boundaries(0, 1);
  return fmt::format("n = {}: T12 {} +- {} by lobes, {} +- {} by boundaries\n", step.n, format_value(lobes.value),
                     format_error(lobes), format_value(boundaries.value), format_error(boundaries));
}

std::string interrupted_transport_table(std::span<const TransportStep> steps, const Agreement& agreement,
                                        int iterates) {
  return agreement_text(agreement) + transport_steps_table(steps) +
         fmt::format("n = 1 to {} of {}: interrupted\n", steps.size(), iterates);
}

std::string transport_table(const TransportReport& report) {
  const operations::SystemTransport& result = report.result();
  std::string text = agreement_text(result.agreement) + system_text(report.system) + "\n";
  for (const TransportBoundary& boundary : result.boundaries) {
    text += saddles_text(*boundary.manifolds) + turnstile_text(*boundary.manifolds) + "\n";
  }
  if (result.melnikov) text += melnikov_text(*result.melnikov) + "\n";
  text += regions_text(result.regions) + transport_steps_table(result.steps);
  for (const std::string& remark : result.remarks) text += with_option_names(remark) + "\n";
  return text;
}

std::string transport_table(const CurvesTransportReport& report) {
  const auto& result = report.outcome.as<operations::CurveTransport>();
  std::string text = agreement_text(result.agreement);
  text += fmt::format("turnstile  {} a period; L12(1) {:.15g} +- {:.1e}, L21(1) {:.15g} +- {:.1e}\n",
                      counted(result.period, "lobe", "lobes"), result.flux12.value, result.flux12.error,
                      result.flux21.value, result.flux21.error);
  text += regions_text(result.regions);
  text += result.steps.empty() ? std::string("no row: the curves do not reach f(q)\n")
                               : transport_steps_table(result.steps);
  if (!result.why.empty()) text += with_option_names(result.why) + "\n";
  return text;
}

}  // namespace lober::cli
