// A curve between two vertices of a polyline: the chord, or a cubic that bulges from it.
//
// All interpolations of a segment a -> b have one form,
//   x(t) = a + t (b - a) + t (1 - t) (u + t v),   0 <= t <= 1,
// with u = v = 0 for the chord. So x(0) = a and x(1) = b, and whoever evaluates need not know which one it is.
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernels/point.hpp"

namespace lober {

struct CubicPiece {
  Point a;      ///< x(0)
  Point chord;  ///< x(1) - x(0)
  Point u, v;   ///< the bulge

  [[nodiscard]] Point at(double t) const {
    const double s = 1 - t;
    return {a.x + t * (chord.x + s * (u.x + t * v.x)), a.y + t * (chord.y + s * (u.y + t * v.y))};
  }
};

/// The chord itself. Order 2: the distance to a smooth curve through equally spaced vertices falls as h^2.
[[nodiscard]] CubicPiece linear_piece(Point a, Point b);

/// Signed curvature of the circle through three points, positive where the polyline turns left (Menger):
/// 2 |e f| / (|e| |f| |e + f|) with e = b - a, f = c - b. Zero when two points coincide, and when lengths are so small
/// or large that the product of their squares leaves the range of double (beyond about 1e-75 and 1e75).
[[nodiscard]] double curvature(Point a, Point b, Point c);

/// Dritschel's local cubic (Contour surgery, J. Comput. Phys. 77, 1988, section 2): x = a + p (b - a) + eta(p) n with n
/// the chord turned left by a right angle and eta = mu p + beta p^2 + gamma p^3, where
///   mu = -e (2 k_a + k_b) / 6,  beta = e k_a / 2,  gamma = e (k_b - k_a) / 6,   e = |b - a|.
/// Then eta(0) = eta(1) = 0 and eta'' / e, the curvature for small slopes, is k_a and k_b at the ends. Order 4 on
/// smooth curves whose spacing varies smoothly, 3 on others. Local: it looks one vertex further on either side.
[[nodiscard]] CubicPiece dritschel_piece(Point a, Point b, double curvature_a, double curvature_b);

/// The piece of a cubic spline over the chord length h = |b - a|, from its second derivatives with respect to that
/// length.
[[nodiscard]] CubicPiece spline_piece(Point a, Point b, Point second_a, Point second_b);

/// Writes x(k / parts) for k = first, ..., last - 1 (0 < first, last <= parts).
void subdivide(const CubicPiece& piece, std::uint32_t parts, std::uint32_t first, std::uint32_t last, Point* out);

/// The longest squared distance between neighbours of x(0), x(1 / parts), ..., x(1).
[[nodiscard]] double longest_part_squared(const CubicPiece& piece, std::uint32_t parts);

/// The angle between the directions a -> b and b -> c, from 0 (straight on) to pi; 0 if either has no length.
[[nodiscard]] double turning_angle(Point a, Point b, Point c);

/// An upper bound of it that costs a division only: its tangent up to a right angle, infinity beyond.
[[nodiscard]] double turning_angle_bound(Point a, Point b, Point c);

}  // namespace lober
