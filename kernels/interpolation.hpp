// A curve between two vertices of a polyline: the chord, or a cubic that bends away from it.
//
// All interpolations of a segment a -> b have one form,
//   x(t) = a + t (b - a) + t (1 - t) (u + t v),   0 <= t <= 1,
// with u = v = 0 for the chord. So x(0) = a and x(1) = b, and whoever evaluates need not know which one it is.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "kernels/point.hpp"

namespace lober::detail {

struct CubicPiece {
  Point a;      ///< x(0)
  Point chord;  ///< x(1) - x(0)
  Point u, v;   ///< how far it leaves the chord

  [[gnu::always_inline, nodiscard]] Point at(double t) const {
    const double s = 1 - t;
    return {a.x + t * (chord.x + s * (u.x + t * v.x)), a.y + t * (chord.y + s * (u.y + t * v.y))};
  }
};

/// The chord itself. Order 2: the distance to a smooth curve through equally spaced vertices falls as h^2.
[[nodiscard]] inline CubicPiece linear_piece(Point a, Point b) {
  return {a, b - a, {}, {}};
}

/// Signed curvature of the circle through three points, positive where the polyline turns left (Menger):
/// 2 |e f| / (|e| |f| |e + f|) with e = b - a, f = c - b. Zero when two points coincide, and when lengths are so small
/// or large that the product of their squares leaves the range of double (beyond about 1e-75 and 1e75).
[[nodiscard]] double curvature(Point a, Point b, Point c);

/// Dritschel's local cubic (Contour surgery, J. Comput. Phys. 77, 1988, section 2): x = a + p (b - a) + eta(p) n with n
/// the chord turned left by a right angle and eta = mu p + beta p^2 + gamma p^3, where
///   mu = -e (2 k_a + k_b) / 6,  beta = e k_a / 2,  gamma = e (k_b - k_a) / 6,   e = |b - a|.
/// Then eta(0) = eta(1) = 0 and eta'' / e, the curvature for small slopes, is k_a and k_b at the ends. Order 4 on
/// smooth curves whose spacing varies smoothly, 3 on others. Local: it looks one vertex further on either side.
[[nodiscard]] inline CubicPiece dritschel_piece(Point a, Point b, double curvature_a, double curvature_b) {
  const Point chord = b - a;
  const double e = std::sqrt(dot(chord, chord));
  // eta = p (1 - p) (mu - gamma p), because mu + beta + gamma = 0.
  const double mu = -e * (2 * curvature_a + curvature_b) / 6;
  const double gamma = e * (curvature_b - curvature_a) / 6;
  return {a, chord, {-mu * chord.y, mu * chord.x}, {gamma * chord.y, -gamma * chord.x}};
}

/// The piece of a cubic spline over the chord length h = |b - a|, from its second derivatives with respect to that
/// length.
[[nodiscard]] inline CubicPiece spline_piece(Point a, Point b, Point second_a, Point second_b) {
  // With M'' linear between M_a and M_b: x = chord - h^2 / 6 t (1 - t) ((2 M_a + M_b) + t (M_b - M_a)).
  const Point chord = b - a;
  const double factor = -dot(chord, chord) / 6;
  return {a,
          chord,
          {factor * (2 * second_a.x + second_b.x), factor * (2 * second_a.y + second_b.y)},
          {factor * (second_b.x - second_a.x), factor * (second_b.y - second_a.y)}};
}

/// Writes x(k / parts) for k = first, ..., last - 1 (0 < first, last <= parts).
void subdivide(const CubicPiece& piece, std::uint32_t parts, std::uint32_t first, std::uint32_t last, Point* out);

/// Bounds on the whole piece: |x'|^2 <= speed2, x' . (b - a) >= advance, |x''|^2 <= bend2. From the Bezier
/// coefficients of x', which are chord + u, chord + v, chord - u - v, and the ends of x''. Cut into n equal parts, the
/// piece has parts of at most |x'| / n; if advance > 0, the sine of the angle between two parts is at most |b - a|
/// |x''| / (n advance), as their chords are means of x' at most 1 / n apart.
struct PieceBounds {
  double speed2, advance, bend2;
};
[[nodiscard]] inline PieceBounds bounds_of(const CubicPiece& piece) {
  const Point chord = piece.chord, u = piece.u, v = piece.v;
  const Point begin{chord.x + u.x, chord.y + u.y}, middle{chord.x + v.x, chord.y + v.y},
      end{chord.x - u.x - v.x, chord.y - u.y - v.y};
  const Point bend_begin{2 * (v.x - u.x), 2 * (v.y - u.y)}, bend_end{2 * u.x + 4 * v.x, 2 * u.y + 4 * v.y};
  return {std::max({dot(begin, begin), dot(middle, middle), dot(end, end)}),
          std::min({dot(begin, chord), dot(middle, chord), dot(end, chord)}),
          std::max(dot(bend_begin, bend_begin), dot(bend_end, bend_end))};
}

/// The angle between the directions a -> b and b -> c, from 0 (straight on) to pi; 0 if either has no length.
[[nodiscard]] double turning_angle(Point a, Point b, Point c);

/// An upper bound of it that costs a division only: its tangent up to a right angle, infinity beyond.
[[nodiscard]] double turning_angle_bound(Point a, Point b, Point c);

}  // namespace lober::detail
