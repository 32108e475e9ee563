#include "cli/densify/densify_report.hpp"

#include <spdlog/fmt/fmt.h>

namespace lober::cli {

std::string densify_summary(const std::vector<NamedCurve>& curves, const operations::RefinedCurve& found) {
  std::string text = fmt::format("{:<20} {:>12} points\n", "given", found.given);
  for (const NamedCurve& input : curves) {
    if (!input.remark.empty()) text += input.file + " " + input.remark + "\n";
  }
  for (const operations::RefinedCurve::Step& step : found.steps) {
    text += fmt::format("{:<20} {:>12} points  {} {}\n", step.name, step.points, step.rounds,
                        step.rounds == 1 ? "round" : "rounds");
  }
  for (const DiagnosticCause cause : all_diagnostic_causes) {
    const std::size_t places = found.places[static_cast<std::size_t>(cause)];
    if (places > 0) text += fmt::format("criteria not met     {:>12} places  ({})\n", places, name(cause));
  }
  return text;
}

Json files_json(const std::vector<NamedCurve>& curves) {
  Json inputs = Json::array();
  for (const NamedCurve& input : curves) {
    inputs.push_back({{"file", input.file},
                      {"zone", input.zone},
                      {"sha256", input.sha256},
                      {"points", input.curve.points.size()},
                      {"closed", input.curve.closed}});
  }
  return inputs;
}

}  // namespace lober::cli
