// Newton's method for points with f^period(z) = z + shift.
#pragma once

#include <span>
#include <vector>

#include "engine/dynamics/maps/plane.hpp"
#include "lober/dynamics/fixed_points.hpp"

namespace lober::detail {

/// f^period(z) - z - shift, and the derivative of f^period.
struct Displacement {
  Point gap;
  Matrix2 derivative;
};

/// f^period(z) - z - shift, of a point and its image.
inline Point gap_between(Point z, Point image, const FixedPointOptions& options) {
  return image - z - options.shift();
}
inline Displacement displacement_at(const PlanarMap& map, Point z, const FixedPointOptions& options) {
  Displacement here{};
  const Point image = map.iterate_with_derivative(z, options.period, here.derivative);
  here.gap = gap_between(z, image, options);
  return here;
}

/// D - 1, whose determinant is the product of 1 - multiplier.
inline Matrix2 less_1(const Matrix2& derivative) {
  return {derivative.xx - 1, derivative.xy, derivative.yx, derivative.yy - 1};
}

/// Where `a` = D - 1 is singular, the shortest step that comes nearest to a zero.
inline Point shortest_step(const Matrix2& a, Point gap) {
  const double squares = a.xx * a.xx + a.xy * a.xy + a.yx * a.yx + a.yy * a.yy;
  return {-(a.xx * gap.x + a.yx * gap.y) / squares, -(a.xy * gap.x + a.yy * gap.y) / squares};
}

/// The size that an error of z is relative to, in a region of this extent.
inline double size_at(Point z, double extent) {
  return size_within(extent, length(z));
}

/// Whether images are exact to rounding: those of maps that integrate nothing.
inline bool by_formula(const PlanarMap& map) {
  return map.work() + map.work_of_derivatives() == 0;
}

/// The displacement, relative to size_at, that rounding or the integration may leave where its derivative is 0.
inline double noise_of(const PlanarMap& map) {
  return by_formula(map) ? 1e-14 : 1e-10;
}

struct NewtonEnd {
  Point at;
  double residual = 0;
  double step = 0;  ///< length of the step from there
  double norm = 0;  ///< the size of the derivative there
  bool converged = false;
};

/// Damped, with steps no longer than `reach`, until the residual falls no further, after nine evaluations at least: the
/// point of the least residual. Converged: that is small, and so is the step from there, or the residual is what
/// rounding leaves; and the map is defined all round the point. A negative period stands for iterates of the inverse.
NewtonEnd newton(const PlanarMap& map, Point guess, const FixedPointOptions& options, double reach);
/// The same from many guesses, whose images are asked for together: flows follow several points at a time. An iteration
/// that leaves `within`, if that is not null, has not converged: outside, images may take as long as they like.
/// `any_point`: the one nearest to a guess is not the one that is wanted. Then steps may be long along valleys of the
/// displacement; and where D - 1 is singular to rounding, as on a curve of fixed points, a step is the shortest that
/// comes nearest to a zero, where it otherwise leads to infinity, and the iteration ends.
[[nodiscard]] std::vector<NewtonEnd> newton(const PlanarMap& map, std::span<const Point> guesses,
                                            const FixedPointOptions& options, double reach,
                                            const Rectangle* within = nullptr, bool any_point = false);

}  // namespace lober::detail
