// Orbits that lead from one saddle to another (or back to the same one), accurate to the last digit, and their actions.
//
// A crossing of two grown manifolds is only as good as their polygons. The orbit through it is known to rounding: it is
// F^a(P_u(sigma)) = F^-c(P_s(tau)), two equations for two numbers. Its action W is the sum of L along it
// (PlanarMap::action); the area of a lobe between two such orbits is the difference of their actions (MacKay, Meiss &
// Percival, Physica D 13, 1984), to the square of the error of their points: no curve is needed.
#pragma once

#include <optional>

#include "lober/base/export.hpp"
#include "lober/dynamics/local_manifold.hpp"
#include "lober/dynamics/manifolds.hpp"
#include "lober/dynamics/planar_map.hpp"
#include "lober/overlay/crossings.hpp"

namespace lober {

/// The point F^(k local.steps)(P(parameter)) of a manifold, k >= 0 the number of `images`; twice that many steps on a
/// manifold whose multiplier is negative.
struct ManifoldPosition {
  int images = 0;        ///< number of images k
  double parameter = 0;  ///< parameter on the local manifold
};

/// A point of a manifold and the direction in which it moves with the parameter.
struct MovingPoint {
  Point at, velocity;  ///< the point, and its derivative by the parameter
};
/// The point at a position of a manifold, and its velocity.
[[nodiscard]] LOBER_API MovingPoint point_on(const PlanarMap& map, const LocalManifold& local,
                                             ManifoldPosition position);

/// The same position with its parameter in the outermost fundamental segment, so that as few steps of the map as
/// possible remain (on the local manifold none).
[[nodiscard]] LOBER_API ManifoldPosition normalised(const LocalManifold& local, ManifoldPosition position);

/// The approximate position of a point of a grown manifold, by linear interpolation of its parameters.
[[nodiscard]] LOBER_API ManifoldPosition position_on(const GrownManifold& grown, const LocalManifold& local,
                                                     Position position);

/// The orbit through a point that both manifolds have in common.
struct ConnectingOrbit {
  Point at;               ///< the point of the orbit nearest to the guess
  ManifoldPosition u, s;  ///< positions of that point on both manifolds
  double residual = 0;    ///< distance of the two expressions for `at`
  /// The sum of L over the orbit, each term less L at the saddle that the orbit comes from (before `at`) or goes to
  /// (from `at` on); nothing when the map has no action.
  std::optional<long double> action;
  /// Estimate of the error of `action`, from PlanarMap::action_accuracy for every step.
  double action_error = 0;
};

/// The orbit near the point that the two positions give. Newton's method; throws DataError with the best point found
/// when it does not converge to rounding (1e-6 of the distance from the saddle is where it gives up). A few dozen
/// evaluations of the map.
[[nodiscard]] LOBER_API ConnectingOrbit connecting_orbit(const PlanarMap& map, const LocalManifold& unstable,
                                                         const LocalManifold& stable, ManifoldPosition u,
                                                         ManifoldPosition s);

/// Signed area of the lobe between two orbits, the first one nearer to the saddle along U: positive if the lobe is on
/// the left of U. Nothing when an action is missing.
[[nodiscard]] LOBER_API std::optional<double> lobe_area_by_action(const ConnectingOrbit& first,
                                                                  const ConnectingOrbit& second);

}  // namespace lober
