// Fixed and periodic points of planar maps.
#pragma once

#include <array>
#include <complex>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "lober/base/export.hpp"
#include "lober/base/progress.hpp"
#include "lober/curve/point.hpp"
#include "lober/dynamics/planar_map.hpp"

namespace lober {

/// The kind by the multipliers, the eigenvalues of the derivative, |first| >= |second|. Moduli within 1e-7 of 1 count
/// as 1.
enum class FixedPointKind {
  saddle,            ///< real, 0 < second < 1 < first: each branch of a manifold is mapped to itself
  inverse_saddle,    ///< real, first < -1 < second < 0: the two branches are exchanged
  reversing_saddle,  ///< real, of opposite signs: the map reverses orientation
  centre,            ///< complex, of modulus 1
  /// real, at least one of modulus 1; or one may be 1 as far as the derivative at the point is known
  parabolic,
  attracting,  ///< both moduli < 1
  repelling    ///< both moduli > 1
};
/// The name of the type.
[[nodiscard]] LOBER_API std::string_view name(FixedPointKind kind);

/// A fixed or periodic point of a map.
struct FixedPoint {
  Point at;  ///< the point
  /// The least n with f^n(at) = at + a multiple of the lattice, of which those that make up the period that was asked
  /// for give the shift that was asked for.
  int period = 1;
  /// Derivative of f^period.
  Matrix2 derivative;
  /// Eigenvalues of the derivative, the one of larger modulus first; of a conjugate pair the one with positive
  /// imaginary part first.
  std::array<std::complex<double>, 2> multipliers;
  /// Unit vectors to x > 0 (to y > 0 when upright), in the order of the multipliers; (0, 0) when those are complex.
  std::array<Point, 2> directions;
  FixedPointKind kind = FixedPointKind::parabolic;  ///< type, by the derivative
  /// |f^period(at) - at - shift|.
  double residual = 0;
};

/// Options of a search for fixed points.
struct FixedPointOptions {
  /// The points searched for satisfy f^period(z) = z + shift.
  int period = 1;
  int turns = 0;    ///< the shift is that many times `lattice`
  Point lattice{};  ///< the vector after which the map repeats itself (System::lattice); a multiple of 2 pi, say
  /// The shift that f^period adds.
  [[nodiscard]] Point shift() const { return {turns * lattice.x, turns * lattice.y}; }
  /// Errors are judged, and steps limited, relative to the smaller of this and 1 + |z|. In searches of a box it is the
  /// extent of the box.
  double extent = std::numeric_limits<double>::infinity();
  /// A scan evaluates f^period on grid x grid points.
  int grid = 48;
  /// The work that `search_fixed_points` may take, as PlanarMap::work counts it. Not used with `budget`.
  double max_work = 5e7;
  double budget = 0;  ///< seconds by the clock instead: results then depend on the machine; 0: max_work
};

/// Newton's method from `guess`, damped, until rounding (or the tolerance of the integration) stops it. Throws
/// DataError with the point where it ended when it does not converge, UsageError for a period or a grid that is not
/// positive, and for turns of a map without a lattice.
[[nodiscard]] LOBER_API FixedPoint find_fixed_point(const PlanarMap& map, Point guess,
                                                    const FixedPointOptions& options = {});

/// The points in a box, each once, sorted by period, x, y. Newton's method starts in each cell of a grid on whose
/// corners both components of f^period(z) - z - shift change sign, and at each grid point where its length is least
/// among its neighbours: it finds every point that the grid resolves. Half a way on is compared with half a way back
/// instead, for one step where it has halves (PlanarMap::half), so that a saddle of multiplier lambda asks for a grid
/// as fine as 1 / sqrt(lambda), not 1 / lambda. The images of a point in the box are among them, and its copies after
/// options.lattice, and points whose least period divides `period`. Throws DataError, with the point of the smallest
/// displacement, when there is none.
[[nodiscard]] LOBER_API std::vector<FixedPoint> find_fixed_points(const PlanarMap& map, const Rectangle& box,
                                                                  const FixedPointOptions& options = {});

/// Greene's residue (2 - trace of the derivative) / 4 (J. Math. Phys. 20, 1979): for a map that preserves area it is
/// negative at a saddle, between 0 and 1 at a centre, above 1 at an inverse saddle.
[[nodiscard]] LOBER_API double residue(const FixedPoint& point);

/// The index of the point as a zero of f^period(z) - z - shift: the sign of det(1 - D f^period), +1 or -1; 0 where that
/// may be 0 as far as the derivative is known. `period` has to be a multiple of the point's.
[[nodiscard]] LOBER_API int index_of(const FixedPoint& point, int period);

/// The result of search_fixed_points.
struct FixedPointSearch {
  std::vector<FixedPoint> points;  ///< as find_fixed_points gives them; may be empty
  int grid = 0;                    ///< grid of the last scan
  /// The last scan found what the one before had found, each of these points has an index, and that of the box, if it
  /// is known, is their sum; if both found nothing, it has to be known.
  bool settled = false;
  /// Whether the points are isolated, as far as the search can tell. Where they fill a curve or an area it ends after
  /// one scan, and `points` has some dozens of them.
  bool isolated = true;
  bool out_of_work = false;  ///< the allowed work ended the search: the points are those found by then
  /// The sum of the indices of the points inside the box; that of a degenerate one is counted on a small circle round
  /// it. 0 where one is not known.
  int index_sum = 0;
  /// How often f^period(z) - z - shift turns round while z runs round the box: the sum of the indices of all points
  /// inside, where the map is continuous there. None where a point lies next to the edge of the box, the index of a
  /// degenerate one is not known, or some point of the box has no image.
  std::optional<int> index_of_box;
};

/// The points in a box, by scans on grids of options.grid, twice as many, ... points a side, until two in a row find
/// the same points and the sum of their indices is that of the box; the last scan has at most max_grid points a side.
/// Fixed points that are not isolated, but fill a curve or an area, end it after one scan. The first grid is coarser
/// where its points alone would take more than a quarter of the work that is allowed. `progress` is called when a scan
/// begins. Throws UsageError, Cancelled. Parallel; the same bits for any number of threads.
[[nodiscard]] LOBER_API FixedPointSearch search_fixed_points(const PlanarMap& map, const Rectangle& box,
                                                             const FixedPointOptions& options = {}, int max_grid = 384,
                                                             const Progress& progress = {});

}  // namespace lober
