// The findings of `lober escape`, and how they are shown.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/picture/picture_options.hpp"
#include "engine/operations/escape_choice.hpp"
#include "lober/operations.hpp"

namespace lober::cli {

struct EscapeReport {
  SystemInfo system;  ///< with the values chosen
  std::shared_ptr<const Flow> flow;
  operations::Outcome outcome;
  operations::Options options;
  bool lists_counts = false;  ///< whether to list the counts of the check by trajectories
  double escape_seconds = 0;
  struct {
    bool unstable = true, stable = true;
    std::vector<Point> trajectories{};  ///< where they begin, on the section
  } tubes{};                            ///< choices for the picture of tubes

  /// Without table when no crossings were asked for.
  [[nodiscard]] const operations::SystemEscape& result() const { return outcome.as<operations::SystemEscape>(); }
  [[nodiscard]] int crossings_asked() const { return static_cast<int>(options.whole("crossings")); }
};

using detail::table::bottleneck_names;

/// Orbits and tubes.
[[nodiscard]] std::string escape_heading(const std::string& system, const Escape& result);
/// The rows of n, one line for each entrance and exit; under a heading those of n = 1.
[[nodiscard]] std::string escape_rows(const Escape& result, int n);
/// The summary after all rows: why the table ends, who remains, how well routes agree, what was counted.
[[nodiscard]] std::string escape_summary(const EscapeReport& report);
/// "n = 1..3 of 7: the next image needs 4e+07 points (--max-points 2000000)"
[[nodiscard]] std::string stop_text(const EscapeReport& report);

/// The periodic orbits as 256 points of position each, "orbit left", "orbit right", and all curves as zones: "entrance
/// left", "entrance left f^1", ..., "exit left", "exit left f^-1", ...; f is the map to the next crossing, in either
/// direction. " cut" follows for a curve that is the image of the part that has not left yet, " open" for one that
/// trajectories which do not get here leave open.
void write_escape_curves(const std::string& path, const std::string& format, const EscapeReport& report);

/// Whether tubes are written as legacy VTK, not drawn. Throws UsageError for another ending.
[[nodiscard]] bool is_vtk(const std::string& path);
/// The surfaces of the tubes that were chosen, between their orbits and the section, the coordinate across the section,
/// the other position and its velocity as x, y and z: as quads for other programs (.vtk), or as a picture (.svg, .pdf,
/// .png), with the trajectories. Throws DataError when there is none.
void write_escape_tubes(const std::string& path, const Flow& flow, const EscapeReport& report,
                        const FigureStyle& style);

/// The curves on the section in its direction, with their common parts filled; borrowed. Throws DataError when there is
/// none.
[[nodiscard]] Figure escape_figure(const EscapeReport& report);

}  // namespace lober::cli
