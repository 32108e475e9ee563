// The tangle of two saddles of a map, with manifolds grown as far as the tangle needs them.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lober/base/agreement.hpp"
#include "lober/base/export.hpp"
#include "lober/base/progress.hpp"
#include "lober/dynamics/connecting_orbit.hpp"
#include "lober/dynamics/systems.hpp"
#include "lober/tangle/tangle.hpp"

namespace lober {

/// Options of grow_tangle.
struct ManifoldTangleOptions {
  /// The largest distance between polygon and manifold. With smooth areas their error is far smaller (order h^6 against
  /// h^2). Where the manifolds lie closer to each other than thirty times this it is made smaller: else polygons would
  /// cross where manifolds do not.
  double tolerance = 1e-5;
  int before = 1;   ///< images of the bip q that are wanted: from f^-before(q)
  int after = 0;    ///< images of the bip after it: to f^after(q)
  Point lattice{};  ///< as in System: manifolds are followed exactly however far along it they lead
  std::optional<Point>
      bip_near{};         ///< default: as in the system's Connection, else the pip up to which U is as long as S
  bool smooth = true;     ///< whether areas are those of smooth curves
  int max_iterates = 60;  ///< iterates of either manifold at most
  std::size_t max_points = 20'000'000;  ///< points of each manifold at most
  /// Work that both manifolds may take in all, in evaluations of the vector field (PlanarMap::work; steps of the map
  /// where there is none); some ten million a second on one core of a machine of today, more for built-in systems. Not
  /// used with `budget`.
  double max_work = 1e8;
  double budget = 0;  ///< seconds that growing may take, by the clock: results then depend on the machine; 0: max_work
  Progress progress{};  ///< called with lines about the step being done
};

/// The two manifolds, their tangle with the period of the map known, and the orbits of the pips of one period. Beyond
/// eight times the size of the scene (saddles and local manifolds) manifolds are followed coarsely, beyond 500 times
/// distances are logarithmic: areas of lobes that reach there mean nothing, but their common areas with others near by
/// do.
struct ManifoldTangle {
  LocalManifold local_u, local_s;  ///< the manifolds next to their saddles
  GrownManifold u, s;              ///< the manifolds
  Tangle tangle;                   ///< tangle of u and s
  std::size_t bip = 0;             ///< number of the pip q
  Rectangle fine;                  ///< where manifolds are as fine as asked; beyond, they are followed coarsely
  Rectangle true_size;             ///< beyond it distances from its middle are logarithmic, so that no number overflows
  double tolerance = 0;            ///< tolerance that the manifolds were grown to in the end
  /// Orbits of the pips from bip - period to bip: those that bound the lobes of the turnstile.
  std::vector<ConnectingOrbit> orbits;
  /// Signed areas of the turnstile lobes by action, in the order of the lobes, and estimates of their errors; empty if
  /// the map has no action.
  std::vector<double> areas_by_action, action_errors;
  /// Sign changes of the distance of the manifolds along one iterate, counted without polygons; 0 where the manifolds
  /// are too far apart for that, else as many as the period.
  std::size_t splitting_zeros = 0;
  /// How far the points of U and S lie beside the manifolds by rounding and integration, up to each pip: estimates,
  /// which errors of areas in `tangle` contain.
  std::vector<double> point_errors_u, point_errors_s;

  /// Number of pips from one to its image.
  [[nodiscard]] std::size_t period() const { return tangle.images.period; }
  /// The pip f^n(q).
  [[nodiscard]] std::size_t image_of_bip(int n) const {
    return bip + static_cast<std::size_t>(static_cast<std::ptrdiff_t>(period()) * n);
  }
};

/// Grows U from the saddle near connection.from and S from the one near connection.to, piece by piece, until the pips
/// from f^-before(q) to f^after(q) are there. The map itself decides which pip is the image of which. Throws DataError
/// with the reason when the manifolds do not cross within the limits, when they coincide as far as double precision and
/// the integration show, when the pips found are not those of the manifolds at any tolerance that can be had, when
/// points or work run out, or when the given points are not saddles; UsageError; Cancelled.
[[nodiscard]] LOBER_API std::unique_ptr<ManifoldTangle> grow_tangle(const PlanarMap& map, const Connection& connection,
                                                                    const ManifoldTangleOptions& options = {});

/// The boundary B(q) = U[p-, q] u S[q, p+], followed by the corners of Tangle::closure: a closed polygon, or, where p+
/// is p- on a cylinder, an open one. O(its vertices).
[[nodiscard]] LOBER_API std::vector<Point> boundary_curve(const ManifoldTangle& manifolds);

/// As remark_on_boundary of the tangle; also empty where the boundary runs round a cylinder, which repeats itself after
/// `lattice` (System::lattice), and needs no path that closes it. O(1).
[[nodiscard]] LOBER_API std::string remark_on_boundary(const ManifoldTangle& manifolds, Point lattice);

/// Comparisons by two routes: the areas of the turnstile's lobes by geometry and by action, the areas that leave and
/// enter in one step (for maps with an action, which preserve area), and the number of pips a period by polygons and by
/// the splitting.
[[nodiscard]] LOBER_API Agreement agreement_of(const ManifoldTangle& manifolds);

}  // namespace lober
