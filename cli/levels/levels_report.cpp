#include "cli/levels/levels_report.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "cli/report/curve_file.hpp"
#include "cli/report/table.hpp"
#include "lober/curve/files.hpp"

namespace lober::cli {
std::string levels_table(const LevelsReport& report) {
  const std::vector<operations::SystemLevel>& levels = report.result().levels;
  const LevelGrid& grid = *report.result().grid;
  std::string text = system_text(report.system) + "\n";
  text += report.system.flow->dimension() == 2
              ? fmt::format("levels     of H(x, y) at time {:.10g}\n", report.time)
              : std::string("levels     of the potential, the least energy at a position\n");
  text += fmt::format("grid       {} x {} cells on [{:.10g}, {:.10g}] x [{:.10g}, {:.10g}]\n", grid.columns(),
                      grid.rows(), grid.window().min_x, grid.window().max_x, grid.window().min_y, grid.window().max_y);
  const Table table({{report.quantity(), 22, Align::right, 0},
                     {"curves", 7},
                     {"closed", 7},
                     {"points", 8},
                     {"saddle", 0, Align::left, 2}});
  text += "\n" + table.head();
  double largest = 0;
  for (const operations::SystemLevel& level : levels) largest = std::max(largest, std::fabs(level.value));
  for (const operations::SystemLevel& level : levels) {
    // A level of 0 is off by rounding of the others.
    const double value = std::fabs(level.value) < 1e-15 * largest ? 0 : level.value;
    std::vector<std::string> cells{fmt::format("{:.16g}", value), std::to_string(level.curves.size()),
                                   std::to_string(level.closed()), std::to_string(level.points())};
    if (level.saddle) cells.push_back(fmt::format("({:.10g}, {:.10g})", level.saddle->x, level.saddle->y));
    text += table.row(cells);
  }
  return text;
}

void write_levels(const std::string& path, const std::string& format, const LevelsReport& report) {
  std::vector<Zone> zones;
  for (const operations::SystemLevel& level : report.result().levels) {
    for (std::size_t k = 0; k < level.curves.size(); ++k) {
      const LevelCurve& curve = level.curves[k];
      zones.push_back(
          {fmt::format("energy {} curve {} {}", level.value, k, curve.closed ? "closed" : "open"), curve.points});
      zones.back().numbers = {{"energy", level.value}};
      zones.back().closed = curve.closed;
    }
  }
  write_curve_file(path, zones,
                   {.format = format,
                    .notes = notes_of("levels", report.outcome, {}, system_note(report.system)),
                    .zone_lines = ZoneLines::always});
}

}  // namespace lober::cli
