// The stable or unstable manifold near a saddle, as a polynomial of high degree with a measured defect.
//
// In the parameterisation method (Cabre, Fontich & de la Llave 2003) the manifold is a curve P with
// F(P(s)) = P(lambda s), P(0) the saddle. P is a Chebyshev polynomial on [-r, r] whose coefficients, and lambda with
// them, solve that equation at nodes that are twice as many as these numbers, by Gauss-Newton. The method uses values
// and derivatives of F only, so maps given by formulas and by integrations are treated alike, and errors of the
// derivative (flows: to the tolerance of the integration) only slow the convergence; the solution belongs to the
// values. Power series would need F as a series, and converge worse: coefficients of a Chebyshev expansion are of the
// size of the curve for any r.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "lober/base/export.hpp"
#include "lober/dynamics/planar_map.hpp"

namespace lober {

/// The manifold of a saddle on which orbits leave it, or that on which they approach it.
enum class ManifoldSide : std::int8_t {
  stable = -1,   ///< contracted by F; treated as unstable under its inverse
  unstable = 1,  ///< expanded by F
};

/// Both manifolds.
inline constexpr std::array<ManifoldSide, 2> all_manifold_sides{ManifoldSide::unstable, ManifoldSide::stable};
/// The name of the side.
[[nodiscard]] constexpr std::string_view name(ManifoldSide side) {
  return side == ManifoldSide::unstable ? "unstable" : "stable";
}

struct LocalManifold;

/// Options of local_manifold.
struct LocalManifoldOptions {
  int period = 1;   ///< the saddle is fixed by F^period, which takes the place of F below
  int degree = 40;  ///< degree of the polynomial
  double tolerance =
      1e-14;  ///< bound on the defect, relative to the saddle's largest coordinate or map.unit() if it is less
  double max_length = 100;  ///< r is not taken larger than this, in units of map.unit()
  /// The manifold of a map near this one: the solution starts from it, with its noise and r (less, where that is a
  /// little too large), at about a twentieth of the cost, and its defect is measured between the nodes only. Where the
  /// defect is then more than twice the allowed one, the result is as without a neighbour.
  const LocalManifold* neighbour = nullptr;
  bool outgrow_neighbour = false;  ///< whether r becomes larger than the neighbour's where that is far too small
};

/// s in [-reach, reach] gives both branches; s is arc length from the saddle to first order. The branch s > 0 leaves
/// the saddle towards larger x (towards larger y, if its tangent is vertical).
struct LocalManifold {
  Point saddle;                                ///< the fixed point
  Point tangent;                               ///< unit vector
  ManifoldSide side = ManifoldSide::unstable;  ///< whether it is the stable or the unstable manifold
  int steps = 1;          ///< iterates of F that the multiplier stands for: +- period, negative for the stable side
  double multiplier = 0;  ///< lambda of F^steps, so |lambda| > 1; negative at an inverse saddle
  double reach = 0;       ///< r
  std::vector<Point> coefficients;  ///< coefficients of T_j(s / reach)
  /// max |F^steps(P(s)) - P(lambda s)| over |s| <= reach / |lambda|, between the nodes, and the same for its component
  /// across the curve. The component along the curve, which images do not feel (it slides points along the manifold),
  /// cannot be less than rounding at s times |lambda|.
  double defect = 0;
  double defect_across = 0;  ///< the component of `defect` across the curve
  /// Four times the smallest values of both defects that could be reached near the saddle: errors of the map itself.
  double noise = 0, noise_across = 0;

  /// P(s), |s| <= reach.
  [[nodiscard]] LOBER_API Point at(double s) const;
  /// points[k] = P(parameters[k]), |parameters[k]| <= reach; the same bits in any span.
  LOBER_API void points_at(std::span<const double> parameters, std::span<Point> points) const;
  [[nodiscard]] LOBER_API Point slope(double s) const;  ///< P'(s)

  /// The map that takes each branch to itself: `steps` of F, or twice as many where a negative multiplier exchanges the
  /// branches; and the factor > 1 in s that they stand for.
  struct Image {
    int steps;      ///< number of iterates of F, negative for the stable side
    double factor;  ///< factor of s
  };
  /// The map that takes each branch to itself.
  [[nodiscard]] LOBER_API Image image() const;
};

/// The manifold of the saddle near `guess`, which is refined by Newton's method first. r is the largest (to a factor
/// of 2^(1/4)) for which defect_across <= e and defect <= |lambda| e, where e is the tolerance, or four times the
/// smallest defect that could be reached near the saddle if that is larger, as it is when the map is integrated to a
/// tolerance. Throws DataError with the point when there is no fixed point, when it is not a saddle, or when the map
/// cannot be evaluated near it; UsageError for options that make no sense. About 5000 evaluations of the map with
/// derivative, in parallel.
[[nodiscard]] LOBER_API LocalManifold local_manifold(const PlanarMap& map, Point guess, ManifoldSide side,
                                                     const LocalManifoldOptions& options = {});

}  // namespace lober
