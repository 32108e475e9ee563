// The findings of `lober overlay`, for the table, the files and the picture to show.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cli/picture/picture_options.hpp"
#include "cli/program/curves_run.hpp"
#include "cli/report/curve_file.hpp"
#include "cli/report/report.hpp"
#include "engine/base/output_file.hpp"

namespace lober::cli {

using operations::CurveOverlay;
using operations::CurveRegions;

/// The kind of the node: "crossing", "touch" or "shared_arc".
[[nodiscard]] inline const char* kind_of(const Node& node) {
  if (node.shared != 0) return "shared_arc";
  return node.rho != 0 ? "crossing" : "touch";
}

/// The short aligned table for people.
[[nodiscard]] std::string overlay_table(const CurvesReport& report);

/// The number of classes of sigma.
[[nodiscard]] std::size_t class_count(const std::vector<SigmaStep>& steps);
/// rho, A, gamma, sigma, class and S of the crossings, for both pairings; empty unless they were asked for.
[[nodiscard]] std::string classes_text(const CurveOverlay& found);
/// Names of the columns that `sigma` adds to the crossings, each after a comma, and those of one node.
[[nodiscard]] std::string sigma_columns();
void append_sigma(std::string& text, const CurveOverlay& found, std::size_t node);
/// The step of a node, by bisection; null for a touch.
[[nodiscard]] const SigmaStep* step_of(const std::vector<SigmaStep>& steps, std::size_t node);

/// One Tecplot zone for each piece of C1 \ C2, then of C2 \ C1; the holes of a piece follow it as zones of
/// their own.
void write_lobes(const std::string& path, const CurveOverlay& found, const CurveFileOptions& options);
/// The member `rings` of the JSON: for each pairing and each of its pieces the outer ring, then the holes, as points
/// [x, y].
void write_rings(detail::OutputFile& file, const CurveOverlay& found);
void write_lobes(const std::string& path, const CurveRegions& found, const CurveFileOptions& options);

/// The nodes as comma-separated columns, which a comment at the top of the file explains.
/// As comma-separated columns, or, where the name ends in .npy, as a structured NumPy array.
void write_crossings(const std::string& path, const CurveOverlay& found);
void write_crossings_npy(const std::string& path, const CurveOverlay& found);

/// Title, axes and window of a picture of two curves; and their crossings as dots, where they are few.
[[nodiscard]] Figure overlay_frame(const Crossings& nodes, const std::array<NamedCurve, 2>& inputs);
[[nodiscard]] Layer crossings_layer(const Crossings& nodes);
/// The two curves and the pieces of C1 \ C2, A0, A1, ..., and C2 \ C1, B0, B1, ... With classes the crossings have
/// their numbers, tangents and signs of rho, and the pieces of C1 \ C2 colours and arrows of the classes of sigma.
/// Figures borrow points of what they show.
[[nodiscard]] Figure overlay_figure(const CurveOverlay& found, const std::array<NamedCurve, 2>& inputs,
                                    const PictureRequest& how);
[[nodiscard]] Figure classes_figure(const CurveOverlay& found, const std::array<NamedCurve, 2>& inputs);
/// The pieces by a fill rule.
[[nodiscard]] Figure regions_figure(const CurveRegions& found, const std::array<NamedCurve, 2>& inputs);

}  // namespace lober::cli
