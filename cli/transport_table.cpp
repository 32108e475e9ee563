// The table of `lober transport` for people.

#include <spdlog/fmt/fmt.h>

#include <cmath>

#include "cli/transport_report.hpp"
#include "cli/turnstile_report.hpp"

namespace lober::cli {

std::string transport_table(const TransportReport& report) {
  const Transport& result = report.result;
  std::string text = system_text(report.system) + "\n";
  text += saddles_text(report.manifolds());
  text += fmt::format("region     area {:.15g}, inside U to the bip and S from there\n", result.region);
  text += turnstile_text(report.manifolds());
  text += fmt::format("\n{:>4} {:>18} {:>18} {:>18} {:>18} {:>11} {:>8} {:>8}\n", "n", "a(n)", "T(n)", "overlap",
                      "T by boundaries", "difference", "+- T", "+- bound");
  for (const TransportStep& step : result.steps) {
    text += fmt::format("{:>4} {:>18.14g} {:>18.14g} {:>18.14g} {:>18.14g} {:>11.1e} {:>8.0e} {:>8}\n", step.n,
                        step.flux, step.total, step.overlap, step.by_boundaries, step.consistency, step.discretisation,
                        std::isnan(step.boundary_error) ? "polygon" : fmt::format("{:.0e}", step.boundary_error));
  }
  return text;
}

}  // namespace lober::cli
