#include "cli/levels/levels_report.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "cli/report/json_file.hpp"
#include "lober/files.hpp"

namespace lober::cli {
namespace {

std::size_t closed_of(const Level& level) {
  return static_cast<std::size_t>(
      std::count_if(level.curves.begin(), level.curves.end(), [](const LevelCurve& curve) { return curve.closed; }));
}

std::size_t point_count(const Level& level) {
  std::size_t points = 0;
  for (const LevelCurve& curve : level.curves) points += curve.points.size();
  return points;
}

}  // namespace

std::string levels_table(const LevelsReport& report, const LevelGrid& grid) {
  std::string text = system_text(report.system) + "\n";
  text += report.system.flow->dimension() == 2
              ? fmt::format("levels     of H(x, y) at time {:.10g}\n", report.time)
              : std::string("levels     of the potential, the least energy at a position\n");
  text += fmt::format("grid       {} x {} cells on [{:.10g}, {:.10g}] x [{:.10g}, {:.10g}]\n", grid.columns(),
                      grid.rows(), grid.window().min_x, grid.window().max_x, grid.window().min_y, grid.window().max_y);
  text += fmt::format("\n{:>22} {:>7} {:>7} {:>8}  {}\n", report.quantity(), "curves", "closed", "points", "saddle");
  double largest = 0;
  for (const Level& level : report.levels) largest = std::max(largest, std::fabs(level.value));
  for (const Level& level : report.levels) {
    // A level of 0 is off by rounding of the others.
    const double value = std::fabs(level.value) < 1e-15 * largest ? 0 : level.value;
    text +=
        fmt::format("{:>22.16g} {:>7} {:>7} {:>8}", value, level.curves.size(), closed_of(level), point_count(level));
    if (level.saddle) text += fmt::format("  ({:.10g}, {:.10g})", level.saddle->x, level.saddle->y);
    text += "\n";
  }
  return text;
}

void write_levels_json(const std::string& path, const LevelsReport& report, const LevelGrid& grid,
                       const std::function<double()>& seconds_so_far) {
  JsonFile json(path, "levels");
  const Rectangle& window = grid.window();
  json.member("system", system_json(report.system, report.integration));
  json.member("options", {{"time", report.time},
                          {"energy", report.energy ? Json(*report.energy) : Json()},
                          {"box", {window.min_x, window.min_y, window.max_x, window.max_y}},
                          {"grid", {grid.columns(), grid.rows()}}});
  Json saddles = Json::array(), levels = Json::array();
  for (const Equilibrium& saddle : report.saddles) {
    saddles.push_back({{"at", point_json(saddle.at)}, {"energy", saddle.energy}});
  }
  for (const Level& level : report.levels) {
    levels.push_back({{"energy", level.value},
                      {"saddle", level.saddle ? point_json(*level.saddle) : Json()},
                      {"curves", level.curves.size()},
                      {"closed", closed_of(level)},
                      {"points", point_count(level)}});
  }
  json.member("saddles", saddles);
  json.member("levels", levels);
  json.finish({{"levels", report.seconds}, {"total", seconds_so_far()}});
}

void write_levels(const std::string& path, const LevelsReport& report) {
  std::vector<Zone> zones;
  for (const Level& level : report.levels) {
    for (std::size_t k = 0; k < level.curves.size(); ++k) {
      const LevelCurve& curve = level.curves[k];
      zones.push_back(
          {fmt::format("energy {} curve {} {}", level.value, k, curve.closed ? "closed" : "open"), curve.points});
    }
  }
  write_tecplot(path, zones, ZoneLines::always);
}

}  // namespace lober::cli
