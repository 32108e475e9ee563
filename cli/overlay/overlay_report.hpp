// Everything that `lober overlay` found, for the table, the JSON, the files and the picture to show.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/report/json.hpp"
#include "cli/report/report.hpp"
#include "lober/agreement.hpp"
#include "lober/overlay.hpp"
#include "lober/smooth.hpp"

namespace lober::cli {

/// Seconds; `read`, `measures` and `write` are the program's own, the rest the engine's.
struct ReportTiming {
  double read = 0, index = 0, check = 0, crossings = 0, order = 0, areas = 0;
  double measures = 0;  ///< centroids, slivers, discretisation
  double verify = 0;    ///< the interior method
  double smooth = 0;    ///< smooth areas
  double write = 0;
};

struct OverlayReport {
  std::array<NamedCurve, 2> inputs;
  OverlayOptions options;
  Overlay result;
  Areas discretisation;
  std::optional<Areas> consistency;  ///< |overlay - interior method|, when that was asked for
  Agreement agreement;               ///< of those two, then
  std::optional<SmoothAreas> smooth;
  /// sigma of A1 \ A2 and of A2 \ A1, when asked for.
  std::optional<std::array<std::vector<SigmaStep>, 2>> steps;
  // By Pairing. Empty for totals only, and for pairings that no output shows; centroids without JSON, too.
  std::array<std::vector<Point>, 4> centroids;
  std::array<Slivers, 4> slivers;
  ReportTiming timing;

  [[nodiscard]] const std::vector<Point>& centroids_of(Pairing pairing) const {
    return centroids[static_cast<std::size_t>(pairing)];
  }
  [[nodiscard]] const Slivers& slivers_of(Pairing pairing) const { return slivers[static_cast<std::size_t>(pairing)]; }
};

/// What kind of node this is: "crossing", "touch" or "shared_arc".
[[nodiscard]] inline const char* kind_of(const Node& node) {
  if (node.shared != 0) return "shared_arc";
  return node.rho != 0 ? "crossing" : "touch";
}

// ---------------------------------------------------------------------------------- ways to show it

/// The short aligned table for people.
[[nodiscard]] std::string overlay_table(const OverlayReport& report);

/// The number of classes of sigma.
[[nodiscard]] std::size_t class_count(const std::vector<SigmaStep>& steps);
/// rho, A, gamma, sigma, class and S of the crossings, for both pairings; empty unless they were asked for.
[[nodiscard]] std::string classes_text(const OverlayReport& report);
/// The member `sigma` of the JSON.
[[nodiscard]] Json sigma_json(const OverlayReport& report);
/// Names of the columns that `sigma` adds to the crossings, each after a comma, and those of one node.
[[nodiscard]] std::string sigma_columns();
void append_sigma(std::string& text, const OverlayReport& report, std::size_t node);

/// Writes the JSON object (docs/conventions.md, section 13); `seconds_so_far` gives the time since the program began
/// and is asked when all but the timing is written.
void write_overlay_json(const std::string& path, OverlayReport& report, const std::function<double()>& seconds_so_far);

/// One Tecplot zone for each piece of C1 \ C2, then of C2 \ C1; the holes of a piece follow it as zones of
/// their own.
void write_lobes(const std::string& path, const OverlayReport& report);

/// The nodes as comma-separated columns, which a comment at the top of the file explains.
void write_crossings(const std::string& path, const OverlayReport& report);

/// An SVG picture of the two curves and of the pieces of C1 \ C2 and C2 \ C1. `window`: the part of the plane that is
/// drawn; none: both curves. With `report.steps` the crossings have their numbers, tangents and colours of rho, and the
/// pieces of C1 \ C2 colours and arrows of the classes of sigma.
void write_picture(const std::string& path, const OverlayReport& report, const std::optional<Rectangle>& window);

}  // namespace lober::cli
