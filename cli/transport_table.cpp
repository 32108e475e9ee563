// The table of `lober transport` for people.

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "cli/transport_report.hpp"
#include "cli/turnstile_report.hpp"

namespace lober::cli {

std::string transport_table(const TransportReport& report) {
  const Transport& result = report.result;
  std::string text = system_text(report.system) + "\n";
  text += saddles_text(report.manifolds());
  if (report.tangle().boundary->crosses_itself) {
    text += "region     not closed by the chord between the saddles, which meets the manifolds: lobes only\n";
  } else {
    text += fmt::format("region     area {:.15g}, inside U to the bip and S from there\n", result.region);
  }
  text += turnstile_text(report.manifolds());
  text += fmt::format("\n{:>4} {:>18} {:>18} {:>18} {:>18} {:>11} {:>8} {:>8}\n", "n", "a(n)", "T(n)", "overlap",
                      "T by boundaries", "difference", "+- T", "+- bound");
  const auto error = [](double value) { return std::isnan(value) ? std::string("-") : fmt::format("{:.0e}", value); };
  for (const TransportStep& step : result.steps) {
    text += fmt::format("{:>4} {:>18.14g} {:>18.14g} {:>18.14g}", step.n, step.flux, step.total, step.overlap);
    text += std::isnan(step.by_boundaries) ? fmt::format(" {:>18} {:>11}", "-", "-")
                                           : fmt::format(" {:>18.14g} {:>11.1e}", step.by_boundaries, step.consistency);
    text += fmt::format(" {:>8} {:>8}\n", error(step.discretisation), error(step.boundary_error));
  }
  const auto cut = std::find_if(result.steps.begin(), result.steps.end(),
                                [](const TransportStep& step) { return std::isnan(step.by_boundaries); });
  if (cut != result.steps.end()) {
    text += fmt::format("the chord between the saddles meets the manifolds from n = {} on: no areas by boundaries\n",
                        cut->n);
  }
  return text;
}

}  // namespace lober::cli
