// Everything that `lober tangle` found, for the table, the JSON, the files and the picture to show.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/picture/picture_options.hpp"
#include "cli/program/system_options.hpp"
#include "cli/report/report.hpp"
#include "lober/operations.hpp"

namespace lober::cli {

struct TangleReport {
  std::array<NamedCurve, 2> inputs;  ///< U and S
  std::array<std::string, 2> specs;  ///< names of curves of files on the command line
  Periods periods;
  std::string lift{};              ///< sentence about the periods by which S was moved (manifold_lift.hpp)
  std::array<bool, 2> reversed{};  ///< turned round after reading: positions speak of the curve as turned
  std::optional<operations::SystemInput> origin{};  ///< system of manifolds grown from equations (`tangle --system`)
  operations::Outcome outcome;                      ///< outcome of tangle or manifold_tangle
  double read_seconds = 0, write_seconds = 0;

  [[nodiscard]] const operations::Operation& operation() const;
  [[nodiscard]] const operations::CurveTangle& result() const;
  /// The grown manifolds; null for curves.
  [[nodiscard]] const ManifoldTangle* manifolds() const;
};

/// Reads a curve as a manifold, outward from its fixed point after turning it round where that is asked for.
[[nodiscard]] NamedCurve read_manifold(const std::string& spec, bool reverse, Periods periods = {});

/// Calls `make`; that a manifold crosses itself is a DataError that names it, U or S, and the point.
void with_names_of(const NamedCurve& u, const NamedCurve& s, const std::function<void()>& make);
/// The tangle of these manifolds; what the engine remarks is logged as warnings.
[[nodiscard]] Tangle tangle_of(const NamedCurve& u, const NamedCurve& s, const TangleOptions& options);

/// The points of the pips, outward along U.
[[nodiscard]] std::vector<Point> pips_of(const Tangle& tangle);

// ---------------------------------------------------------------------------------- ways to show it

/// The short aligned table for people.
[[nodiscard]] std::string tangle_table(const TangleReport& report);

/// Writes the JSON object (docs/conventions.md, section 13); `seconds_so_far` gives the time since the program began.
void write_tangle_json(const std::string& path, TangleReport& report, const std::function<double()>& seconds_so_far);

/// Writes the tangle graph as JSON: every crossing with its order on U and on S, kind and generation, and which run
/// of crossings bounds which lobe.
void write_tangle_graph(const std::string& path, const TangleReport& report);

/// A closed polygon for each lobe.
void write_tangle_lobes(const std::string& path, const TangleReport& report, const std::string& format);
/// The boundary as an open polyline; a file without a curve if there is none.
void write_tangle_boundary(const std::string& path, const TangleReport& report, const std::string& format);
/// The pips as points of one curve, outward along U, if there are any.
void write_tangle_pips(const std::string& path, const TangleReport& report, const std::string& format);

/// The manifolds, the pips, the lobes in two colours and the boundary. Borrows the manifolds.
[[nodiscard]] Figure tangle_figure(const TangleReport& report, const PictureRequest& how);

}  // namespace lober::cli
