#include "cli/interior/interior_report.hpp"

#include <spdlog/fmt/fmt.h>

#include "cli/report/agreement_report.hpp"
#include "cli/report/report.hpp"

namespace lober::cli {
namespace {

std::string method_text(const operations::Outcome& outcome) {
  const operations::Options& options = outcome.options;
  const auto passes = static_cast<std::size_t>(options.whole("passes"));
  if (options.text("method") == "split") return "segments are split where the curves meet";
  if (passes == 0 || options.whole("points") == 0) return "a segment counts by its two ends";
  return fmt::format(
      "a segment counts by its two ends; {} where they differ, {} with {}",
      counted(outcome.as<operations::CurveInterior>().statistics.points_inserted, "point inserted", "points inserted"),
      counted(passes, "pass", "passes"), options.whole("points"));
}

}  // namespace

std::string interior_table(const CurvesReport& report) {
  const auto& found = report.outcome.as<operations::CurveInterior>();
  std::string text = agreement_text(found.agreement);
  text += inputs_text(report.inputs, {found.orientation1, found.orientation2});
  text += fmt::format("\n{}\n{}\n", meetings_text(found.nodes), method_text(report.outcome));
  Table table = areas_table("area of", "");
  if (found.splitting) table.add({"splitting", 11});
  if (found.consistency) table.add({"consistency", 11});
  text += "\n" + table.head();
  for (const NamedArea& area : named_areas) {
    std::vector<std::string> cells = area_cells(area, found.areas, found.rounding);
    if (found.splitting) cells.push_back(fmt::format("{:.1e}", (*found.splitting).*area.member));
    if (found.consistency) cells.push_back(fmt::format("{:.1e}", (*found.consistency).*area.member));
    text += table.row(cells);
  }
  text += fmt::format("\nQ1 {:.16g}, Q2 {:.16g}, Q3 {:.16g}; delta {:.1e} (zero by algebra, no error bar)\n", found.q1,
                      found.q2, found.q3, found.delta);
  return text;
}

}  // namespace lober::cli
