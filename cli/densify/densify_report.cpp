#include "cli/densify/densify_report.hpp"

#include <spdlog/fmt/fmt.h>

#include "cli/report/report.hpp"
#include "cli/report/table.hpp"

namespace lober::cli {

std::string densify_summary(const std::vector<NamedCurve>& curves, const operations::RefinedCurve& found) {
  // Lines that say their units; in Markdown the head of a table does.
  const bool is_markdown = table_format() == TableFormat::markdown;
  const Table table({{"step", 20, Align::left, 0}, {"points", 12}, {"rounds", 0, Align::right, 0}});
  std::string remarks;
  for (const NamedCurve& input : curves) {
    if (!input.remark.empty()) remarks += input.file + " " + input.remark + "\n";
  }
  std::string text = is_markdown ? remarks + table.head() : "";
  text += table.row({"given", std::to_string(found.given)}, is_markdown ? "" : " points");
  if (!is_markdown) text += remarks;
  for (const operations::RefinedCurve::Step& step : found.steps) {
    const std::string points = std::to_string(step.points), rounds = std::to_string(step.rounds);
    text += is_markdown ? table.row({step.name, points, rounds})
                        : table.row({step.name, points}, " points  " + counted(step.rounds, "round", "rounds"));
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
