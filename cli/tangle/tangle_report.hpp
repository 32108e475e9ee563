// Everything that `lober tangle` found, for the table, the JSON, the files and the picture to show.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/program/system_options.hpp"
#include "cli/report/report.hpp"
#include "lober/manifold_tangle.hpp"
#include "lober/tangle.hpp"

namespace lober::cli {

/// Seconds of what the program does around the engine's phases.
struct TangleReportTiming {
  double read = 0;
  double measures = 0;  ///< perimeters, widths, discretisation
  double overlaps = 0;
  double write = 0;
};

/// Where manifolds come from that were grown, not read.
struct TangleOrigin {
  System system;
  IntegrationOptions integration;
  double tolerance = 0;
  std::unique_ptr<ManifoldTangle> manifolds;
};

struct TangleReport {
  std::array<NamedCurve, 2> inputs;    ///< U and S
  std::array<bool, 2> reversed{};      ///< turned round after reading: positions speak of the curve as turned
  std::optional<TangleOrigin> origin;  ///< of manifolds grown from equations (`tangle --system`)
  TangleOptions options;
  Tangle result;
  std::vector<LobeShape> shapes;                     ///< by lobe
  std::optional<std::vector<LobeOverlap>> overlaps;  ///< when asked for
  Agreement agreement;                               ///< of two routes to the same area
  TangleReportTiming timing;
};

/// Reads a curve as a manifold, outward from its fixed point after turning it round where that is asked for.
[[nodiscard]] NamedCurve read_manifold(const std::string& spec, bool reverse);

/// The tangle of these manifolds. A manifold that crosses itself is a DataError that names it, U or S, and the point;
/// what the engine remarks is logged as warnings.
[[nodiscard]] Tangle tangle_of(const NamedCurve& u, const NamedCurve& s, const TangleOptions& options);

/// The points of the pips, outward along U.
[[nodiscard]] std::vector<Point> pips_of(const Tangle& tangle);

/// What the area of a lobe loses against the smooth curves through the points: estimated from the polygon, or, when
/// areas are those of smooth curves, by how far these can be trusted.
[[nodiscard]] double discretisation(const TangleReport& report, std::size_t lobe);

/// Error bars of the report as a whole: the worst lobe, and the boundary.
struct TangleErrors {
  double lobe_rounding = 0, boundary_rounding = 0, boundary_discretisation = 0;
  double lobe_discretisation = 0;
  double split = 0;  ///< largest | |area| - inside - outside |
};
[[nodiscard]] TangleErrors errors_of(const TangleReport& report);

/// Of curves from files whose period was inferred, which supposes that the map preserves area: the area of each lobe
/// against that of its image. Nothing when the user gave the period, since then nothing is known of the map.
[[nodiscard]] Agreement agreement_of_images(const TangleReport& report);

// ---------------------------------------------------------------------------------- ways to show it

/// The short aligned table for people.
[[nodiscard]] std::string tangle_table(const TangleReport& report);

/// Writes the JSON object (docs/conventions.md, section 13); `seconds_so_far` gives the time since the program began.
void write_tangle_json(const std::string& path, TangleReport& report, const std::function<double()>& seconds_so_far);

/// Writes the tangle graph as JSON: every crossing with its order on U and on S, kind and generation, and which run
/// of crossings bounds which lobe.
void write_tangle_graph(const std::string& path, const TangleReport& report);

/// One Tecplot zone for each lobe: a closed polygon.
void write_tangle_lobes(const std::string& path, const TangleReport& report);
/// The boundary as an open polyline; a file without a zone if there is none.
void write_tangle_boundary(const std::string& path, const TangleReport& report);
/// One zone with the pips, outward along U, if there are any.
void write_tangle_pips(const std::string& path, const TangleReport& report);

/// An SVG picture of the manifolds, the pips, the lobes in two colours and the boundary.
struct TanglePicture {
  bool labels = false;              ///< names of fixed points, regions, pips and lobes
  std::optional<Rectangle> window;  ///< the part of the plane that is drawn; default: lobes and boundary
};
void write_tangle_picture(const std::string& path, const TangleReport& report, const TanglePicture& options);

}  // namespace lober::cli
