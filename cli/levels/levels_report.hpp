// Everything that `lober levels` found, for the table, the JSON, the file and the picture to show.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/program/system_options.hpp"
#include "lober/levels.hpp"

namespace lober::cli {

struct Level {
  double value = 0;
  std::optional<Point> saddle;  ///< that the level goes through
  std::vector<LevelCurve> curves;
};

struct LevelsReport {
  System system;
  IntegrationOptions integration;
  double time = 0;
  std::optional<double> energy;  ///< of Hill's region
  bool shaded = false;           ///< few levels: the picture shows the bands between them
  std::vector<Equilibrium> saddles;
  std::vector<Level> levels;  ///< by value, ascending
  double seconds = 0;

  /// H in the plane, or the least H over the momenta.
  [[nodiscard]] const char* quantity() const { return system.flow->dimension() == 2 ? "H" : "potential"; }
};

/// The short aligned table for people.
[[nodiscard]] std::string levels_table(const LevelsReport& report, const LevelGrid& grid);
void write_levels_json(const std::string& path, const LevelsReport& report, const LevelGrid& grid,
                       const std::function<double()>& seconds_so_far);
/// A Tecplot zone for each curve, closed ones without their first point at the end.
void write_levels(const std::string& path, const LevelsReport& report);
/// Level curves, those through saddles in red; the bands between few levels, or what lies outside Hill's region,
/// shaded.
void write_levels_picture(const std::string& path, const LevelsReport& report, const LevelGrid& grid);

}  // namespace lober::cli
