#include "cli/winding/winding_report.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "cli/report/agreement_report.hpp"
#include "cli/report/columns.hpp"
#include "cli/report/outcome_json.hpp"
#include "cli/report/report.hpp"

namespace lober::cli {
namespace {

Orientation orientation_of(const WindingReport& report) {
  return report.signed_area > 0   ? Orientation::counter_clockwise
         : report.signed_area < 0 ? Orientation::clockwise
                                  : Orientation::degenerate;
}

void add_points(std::string& text, const WindingReport& report) {
  const Table table({{"x", 20, Align::right, 0}, {"y", 20}, {"winding", 8}, {"J", 20}});
  text += "\n" + table.head();
  const std::size_t rows = std::min(max_table_rows, report.points.size());
  for (std::size_t k = 0; k < rows; ++k) {
    const std::string winding =
        report.found().windings[k].on ? "on" : std::to_string(report.found().windings[k].number);
    text += table.row({fmt::format("{:.12g}", report.points[k].x), fmt::format("{:.12g}", report.points[k].y), winding,
                       fmt::format("{:.15g}", report.found().values[k].j)});
  }
  if (report.points.size() > rows) text += fmt::format("{:>20} and {} more\n", "...", report.points.size() - rows);
}

}  // namespace

std::string winding_table(const WindingReport& report) {
  std::string text = agreement_text(report.outcome.agreement);
  text += fmt::format("C   {}  {} points, signed area {:.15g}\n", spec_of(report.input),
                      report.input.curve.points.size(), report.signed_area);
  if (!report.input.remark.empty()) text += "C   " + report.input.remark + "\n";
  if (report.grid) {
    const Rectangle& window = report.grid->window;
    text +=
        fmt::format("at  the centres of {} x {} cells of [{:.10g}, {:.10g}] x [{:.10g}, {:.10g}]\n",
                    report.grid->columns, report.grid->rows, window.min_x, window.max_x, window.min_y, window.max_y);
  }
  const Table table({{"winding", 8, Align::right, 0}, {"points", 12}});
  text += "\n" + table.head();
  for (const operations::CurveWinding::Count& count : report.found().counts)
    text += table.row({std::to_string(count.winding), std::to_string(count.points)});
  text += table.row({"on", std::to_string(report.found().on)});
  if (!report.grid) add_points(text, report);
  text += fmt::format("\nJ / 2 pi differs from the winding number by {:.1e} at most\n", report.found().difference);
  return text;
}

void write_winding_columns(const std::string& path, const WindingReport& report) {
  Columns columns;
  columns.names = {"x", "y", "winding", "on", "j"};
  columns.rows = report.points.size();
  if (report.grid) columns.shape = {report.grid->rows, report.grid->columns};
  columns.row = [&](std::size_t k, std::span<double> values) {
    values[0] = report.points[k].x;
    values[1] = report.points[k].y;
    values[2] = report.found().windings[k].number;
    values[3] = report.found().windings[k].on ? 1 : 0;
    values[4] = report.found().values[k].j;
  };
  write_columns(path, columns);
}

void write_winding_json(const std::string& path, const WindingReport& report,
                        const std::function<double()>& seconds_so_far) {
  std::vector<std::pair<std::string, Json>> inputs{
      {"inputs", Json::array({input_json(report.input, std::fabs(report.signed_area), orientation_of(report))})}};
  if (report.grid) {
    const Rectangle& window = report.grid->window;
    inputs.push_back({"grid",
                      {{"box", {window.min_x, window.min_y, window.max_x, window.max_y}},
                       {"columns", report.grid->columns},
                       {"rows", report.grid->rows}}});
  }
  write_outcome_json(path, "winding", inputs, operations::named("winding"), report.outcome, [&] {
    return Json{{"read", report.read_seconds},
                {"index", report.index_seconds},
                {"winding", report.winding_seconds},
                {"write", report.write_seconds},
                {"total", seconds_so_far()}};
  });
}

}  // namespace lober::cli
