// The results of operations: those of the functions of the other headers, with what an operation adds to them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lober/base/agreement.hpp"
#include "lober/base/export.hpp"
#include "lober/base/measured.hpp"
#include "lober/curve/curve.hpp"
#include "lober/curve/densify.hpp"
#include "lober/curve/point.hpp"
#include "lober/dynamics/fixed_points.hpp"
#include "lober/dynamics/levels.hpp"
#include "lober/dynamics/manifolds.hpp"
#include "lober/dynamics/orbits.hpp"
#include "lober/overlay/interior.hpp"
#include "lober/overlay/overlay.hpp"
#include "lober/overlay/regions.hpp"
#include "lober/overlay/smooth.hpp"
#include "lober/tangle/manifold_tangle.hpp"
#include "lober/tangle/tangle.hpp"
#include "lober/transport/escape.hpp"
#include "lober/transport/melnikov.hpp"
#include "lober/transport/monte_carlo.hpp"
#include "lober/transport/sweep.hpp"
#include "lober/transport/transport.hpp"

namespace lober::operations {

/// The result of "overlay".
struct CurveOverlay : Overlay {
  bool has_pieces = true;                 ///< whether pieces were asked for
  std::optional<Areas> discretisation{};  ///< estimates of |area of the polygons - between smooth curves|
  std::optional<Areas> consistency{};     ///< |area - by the interior function|
  std::optional<SmoothAreas> smooth{};    ///< areas between smooth curves, where they were asked for
  std::optional<std::array<std::vector<SigmaStep>, 2>> steps{};  ///< sigma of A1 \ A2 and of A2 \ A1
  Agreement agreement{};                                         ///< comparison with the interior method
  double verify_seconds = 0, smooth_seconds = 0;                 ///< seconds of wall time
};
/// The result of "interior".
struct CurveInterior : InteriorAreas {
  std::optional<Areas> splitting{};    ///< where segments were not split: |area - area with split segments|
  std::optional<Areas> consistency{};  ///< |area - by the overlay|
  Agreement agreement{};               ///< comparison with the overlay
  double verify_seconds = 0;           ///< seconds of wall time
};
/// The result of "densify" and "simplify".
struct RefinedCurve : DensifiedCurve {
  /// A step of the work.
  struct Step {
    std::string name;          ///< "simplify", "criteria", "passes" or "crossings"
    std::size_t points = 0;    ///< number of points after the step
    std::uint32_t rounds = 0;  ///< number of rounds that it took
  };
  std::size_t given = 0;                    ///< number of points
  std::vector<Step> steps{};                ///< in order
  std::optional<DensifiedCurve> against{};  ///< the other curve with the crossings inserted
  /// Number of diagnostics of the criteria, by DiagnosticCause, and of their segments; there are no diagnostics
  /// themselves where a later step has changed the numbers of segments.
  std::array<std::size_t, all_diagnostic_causes.size()> places{};
  std::size_t segments_with_diagnostics = 0;  ///< number of segments that have a diagnostic
};
/// The result of "regions".
struct CurveRegions {
  Regions regions;                                      ///< the arrangement
  FillRule rule = FillRule::nonzero;                    ///< the rule for `areas`
  Areas areas{}, rounding{};                            ///< by the rule
  std::optional<std::array<RegionPieces, 4>> pieces{};  ///< in the order of all_pairings
};
/// The result of "grow".
struct SystemManifold : GrownManifold {
  LocalManifold local{};                         ///< near the saddle
  Branch branch = Branch::plus;                  ///< the branch that was grown
  double local_seconds = 0, growth_seconds = 0;  ///< seconds of wall time
};
/// The result of "winding".
struct CurveWinding {
  /// A winding number and how often it occurs.
  struct Count {
    int winding;         ///< the winding number
    std::size_t points;  ///< number of points with it
  };
  std::span<const Point> points;      ///< the points that were asked for
  std::vector<Winding> windings;      ///< winding number of each point
  std::vector<InteriorValue> values;  ///< J at each point
  std::vector<Count> counts;          ///< ascending; points on the curve are not counted
  std::size_t on = 0;                 ///< points on the curve
  double difference = 0;              ///< the largest |J / 2 pi - winding number|
  double bar = 0;                     ///< bound on the difference
  Agreement agreement;                ///< points where the difference exceeds the bound
};
/// The result of "image".
struct CurveImages {
  /// An image of one curve.
  struct One {
    CurveImage image{};              ///< the image
    std::size_t curve = 0;           ///< 1: the second boundary of a cylinder
    std::vector<ImagePart> parts{};  ///< the image without its gaps
    double length = 0;               ///< length of all parts together
    /// Signed area of an image that is whole and meets the tolerance everywhere; the error is the area that a polygon
    /// may leave out: the tolerance times its length.
    std::optional<Measured> area{};

    [[nodiscard]] LOBER_API std::string name() const;  ///< "f^-2", for a second curve "f^-2 boundary 2"
  };
  std::string what{};           ///< "circle of radius 0.1 about (1, 0)"; empty where a curve was given
  bool closed = true;           ///< whether the curve is closed
  std::vector<Point> bips{};    ///< where the curve is a boundary: its bip; of a strip, those of both
  std::vector<One> images{};    ///< in the order of iterates; of two curves, those of the first one come first
  double tolerance = 0;         ///< the tolerance of images
  Rectangle box{};              ///< the box in which the tolerance holds
  bool preserves_area = false;  ///< the map has an action
  Agreement agreement{};        ///< areas of images against that of the first
  double curve_seconds = 0, image_seconds = 0;  ///< seconds of wall time
};
/// The result of "tangle".
struct CurveTangle : Tangle {
  bool smooth = false;                                 ///< whether areas are those of smooth curves
  std::vector<LobeShape> shapes{};                     ///< shape of each lobe
  double boundary_discretisation = 0;                  ///< estimate of the error of the boundary's area
  std::optional<std::vector<LobeOverlap>> overlaps{};  ///< where they were asked for
  Agreement agreement{};                               ///< comparisons of the result
  double measures_seconds = 0, overlaps_seconds = 0;   ///< seconds of wall time

  /// The error of a lobe's area against the smooth curves through the points: estimated from the polygon, or, when
  /// areas are those of smooth curves, by how far these can be trusted.
  [[nodiscard]] double discretisation(std::size_t lobe) const {
    return smooth ? lobes[lobe].smooth_error : shapes[lobe].discretisation;
  }
  /// The same of its parts inside and outside the boundary, of smooth curves.
  [[nodiscard]] double parts_error(std::size_t lobe) const {
    return lobes[lobe].smooth_error + lobes[lobe].boundary_error;
  }
};
/// The result of "manifold_tangle".
struct SystemTangle : CurveTangle {
  std::shared_ptr<const ManifoldTangle> manifolds{};  ///< the manifolds that were grown
  double growth_seconds = 0;                          ///< seconds of wall time
};
/// The lobes of a turnstile to first order in the size of the system's perturbation, a parameter, beside their areas.
struct MelnikovComparison {
  std::string parameter;            ///< name of the parameter
  double eps = 0;                   ///< its value
  Melnikov function;                ///< Melnikov's function
  Melnikov::Sides estimate, exact;  ///< `exact` by action, where the map has one
};
/// The result of "transport".
struct SystemTransport : Transport {
  std::optional<MelnikovComparison> melnikov{};  ///< where it was asked for
};
/// The result of "curve_transport".
struct CurveTransport : TransportOfCurves {
  std::size_t period = 0;  ///< number of pips from one to its image
  std::string why{};       ///< the limit, with the number of rows
};
/// The result of "escape".
struct SystemEscape : Escape {
  std::optional<MonteCarlo> counted{};  ///< where trajectories were followed
  std::uint64_t seed = 1;               ///< seed of their random numbers
};
/// The result of "fixed_points": the points that were found, and the box that was searched.
struct SystemFixedPoints : FixedPointSearch {
  Rectangle box{};            ///< the box that was searched
  int period = 1, turns = 0;  ///< period of the points, and turns of the cylinder
};
/// A level of the result of "levels".
struct SystemLevel {
  double value = 0;                  ///< energy of the level
  std::optional<Point> saddle{};     ///< the saddle that the level goes through
  std::vector<LevelCurve> curves{};  ///< curves on which the energy has this value

  [[nodiscard]] LOBER_API std::size_t closed() const;  ///< number of closed curves
  [[nodiscard]] LOBER_API std::size_t points() const;  ///< number of points of all curves
};
/// The result of "levels".
struct SystemLevels {
  std::vector<Equilibrium> saddles{};       ///< saddles that levels go through
  std::vector<SystemLevel> levels{};        ///< by value, ascending
  std::shared_ptr<const LevelGrid> grid{};  ///< grid on which the energy was evaluated
};
/// The number of crossings of the section after which orbits leave that begin in the middle of each cell of a grid.
struct ExitTimes {
  Rectangle window{};                  ///< box of the grid
  std::size_t columns = 0, rows = 0;   ///< number of cells along x and along y
  std::vector<std::uint32_t> times{};  ///< row by row from below; the start is the first crossing
  static constexpr std::uint32_t none = 0, stays = 0xffffffff;  ///< section not reached; orbit does not leave

  /// The number of crossings of a cell.
  [[nodiscard]] std::uint32_t of(std::size_t column, std::size_t row) const { return times[row * columns + column]; }
  /// Number of cells that leave after each number of crossings, from 0 (not on the section) on; the rest stay.
  [[nodiscard]] LOBER_API std::vector<std::uint64_t> counts() const;
  /// Number of cells whose orbits do not leave.
  [[nodiscard]] LOBER_API std::uint64_t staying() const;
};
/// The result of "section". Context::on_part gets it with each block of orbits.
struct SystemSection {
  Rectangle box{};                                  ///< box of the picture
  OrbitOptions options{};                           ///< options of the orbits
  std::size_t orbits = 0, lost = 0, unreached = 0;  ///< numbers of orbits
  std::uint64_t points = 0, inside = 0;             ///< points of all orbits, and those in the box
  std::optional<ExitTimes> exit_times{};            ///< where they were asked for
  std::vector<Point> kept{};                        ///< points of all orbits; empty where on_part takes them
  // In on_part: a block as follow_orbits gives it, and which of its starts are points of the section.
  std::size_t first = 0;           ///< number of the first orbit of the block
  std::span<const Point> block{};  ///< points of the orbits of the block
  std::vector<bool> reached{};     ///< whether each start is a point of the section
};
/// The result of "sweep".
struct SystemSweep : Sweep {
  std::string parameter{};  ///< name of the parameter
  std::string no_zero{};    ///< why no zero was found, where zeros were looked for; else empty
  /// For each row, where it was asked for: area of the lobes of one side to first order; NaN where it is not known.
  std::optional<std::vector<double>> first_order{};
  Agreement agreement{};               ///< rows that disagree are failures
  std::vector<std::string> remarks{};  ///< remarks that a user should read
};

}  // namespace lober::operations
