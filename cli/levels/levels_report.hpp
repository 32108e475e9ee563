// Everything that `lober levels` found, for the table, the file and the picture to show.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/picture/figure.hpp"
#include "cli/program/system_options.hpp"

namespace lober::cli {

struct LevelsReport {
  System system;
  double time = 0;
  std::optional<double> energy{};            ///< energy of Hill's region
  bool shaded = false;                       ///< few levels: the picture shows the bands between them
  std::vector<std::vector<Point>> orbits{};  ///< positions of the periodic orbits that the picture shows
  operations::Outcome outcome{};

  [[nodiscard]] const operations::SystemLevels& result() const { return outcome.as<operations::SystemLevels>(); }
  /// H in the plane, or the least H over the momenta.
  [[nodiscard]] const char* quantity() const { return system.flow->dimension() == 2 ? "H" : "potential"; }
};

/// The short aligned table for people.
[[nodiscard]] std::string levels_table(const LevelsReport& report);
/// All curves, closed ones without their first point at the end.
void write_levels(const std::string& path, const std::string& format, const LevelsReport& report);
/// Level curves, those through saddles in the colour of U; the bands between few levels, or the part outside Hill's
/// region, shaded. Borrows the curves.
[[nodiscard]] Figure levels_figure(const LevelsReport& report);

}  // namespace lober::cli
