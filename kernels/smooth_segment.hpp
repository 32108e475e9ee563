// The smooth curve that a segment stands for, as a graph over the segment.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "kernels/point.hpp"

namespace lober::detail {

/// The polynomial of these coefficients, of 1, x, ..., x^5, at x.
[[nodiscard]] inline double value_at(const std::array<double, 6>& polynomial, double x) {
  double value = polynomial.back();
  for (std::size_t power = polynomial.size() - 1; power-- > 0;) value = value * x + polynomial[power];
  return value;
}

/// A piece of smooth curve from vertex a to the next one: a + u e + f(u) e', 0 <= u <= 1, where e is the segment, e' is
/// e turned by +90 degrees, and f is a polynomial with f(0) = f(1) = 0. Zero for a segment that stays straight.
struct SmoothSegment {
  enum class Kind : std::uint8_t {
    smooth,    ///< f interpolates neighbouring vertices
    straight,  ///< the segment itself: no vertex beside it is of use (corners, lengths too different)
    noisy,     ///< the segment itself: what f would be is noise
  };
  Point chord;
  std::array<double, 6> f{};  ///< coefficients of 1, u, ..., u^5
  double error = 0;           ///< estimate of the error of chord_area(1)
  Kind kind = Kind::straight;
  using LeftUnfilled = void;  ///< in arrays (lober/base/buffer.hpp)

  [[nodiscard]] double f_at(double u) const { return value_at(f, u); }
  /// Side by side for many, the same bits.
  template <std::size_t count>
  void f_at(const std::array<double, count>& u, std::array<double, count>& values) const {
    values.fill(f.back());
    for (std::size_t power = f.size() - 1; power-- > 0;) {
      for (std::size_t k = 0; k < count; ++k) values[k] = values[k] * u[k] + f[power];
    }
  }
  [[nodiscard]] Point at(double u) const;        ///< relative to the first end
  [[nodiscard]] Point velocity(double u) const;  ///< its derivative
  /// Twice the signed area between the curve from 0 to u and the straight way back, positive when the curve bends to
  /// the right of the segment: |e|^2 (u f(u) - 2 int_0^u f).
  [[nodiscard]] double chord_area(double u) const;
};

/// The smooth curve from p[3] to p[4] of eight consecutive vertices: f = u (u - 1) g, with g the polynomial of least
/// degree through what the two vertices on either side demand of it, so that f has degree 5 and an error of order h^6
/// on a smooth curve, h the length of segments; chord_area(1) one of h^7, where vertices are as dense on both sides
/// also if they are not evenly spaced. The parameter is length along the chord: how the curve was parametrised does not
/// matter.
///
/// A vertex where the direction turns by more than 45 degrees, or eight times more than at the vertices before and
/// after, is a corner, and no vertex beyond it is used; nor one beyond a segment eight times (the next: sixteen times)
/// longer or shorter, or that leads away by more than 70 degrees. With none left the segment stays straight. It is
/// noisy if turns in use change sign twice, or f is steeper than 45 degrees at an end.
///
/// `error` is what the third vertices on either side would change, three times, which is the error of this formula to
/// leading order, and no less than the changes of orders before let expect; at most, and where these vertices are of no
/// use, the change when g loses its farther vertices, the error of a formula of order h^5, three times it, or the area
/// times the square of the larger turn at an end, where some of those are of no use either; and rounding, that of the
/// vertices given too. Where the segment stays straight it is the size of the chord-to-arc area that was rejected, or
/// that its turns let expect, none at corners. Beside a corner or two that may be the spike of a thin shape, with few
/// vertices, it is at least the difference to the area of a parabola that the chords beside the segment touch.
/// Plain double; 300 operations. One window takes as long as four do.
[[nodiscard]] SmoothSegment fit_smooth_segment(const std::array<Point, 8>& p);

/// The limits that it names.
struct SmoothLimits {
  static constexpr double cosine_of_corner = 0.70710678118654757, cosine_of_stray = 0.34202014332566873;
  static constexpr double outstanding = 8, uneven = 8;
  // At a spike a corner turns no more than this many times more than the vertex beside it: one of two corners in a row,
  // and a single one, which may as well be where two arcs meet.
  static constexpr double two_corners_of_spike = 16, corner_of_spike = 4;
  // Rounding of vertices: half an ulp or a quarter for each segment, added up, is four standard deviations of the sum
  // from a few dozen segments on.
  static constexpr double rounding = 0x1p-54;
};

/// The same for `count` windows, each where eight points in a row begin: several side by side. Returns whether two
/// neighbours in any window lie so close together that their chord has no length.
bool fit_smooth_segments(const Point* const* windows, std::size_t count, SmoothSegment* segments);

/// The result of smooth_chord_areas.
struct StraightSegments {
  std::size_t count;  ///< segments that stay straight
  bool no_length;     ///< whether one of the points' chords has no length; then nothing is computed
};

/// The chord_area(1), the error, and whether the kind is smooth, for `count` segments in a row: the same bits as
/// fit_smooth_segment gives of points[k] to points[k + 7] for segment k, in a fraction of the time. There are count + 7
/// points.
StraightSegments smooth_chord_areas(const Point* points, std::size_t count, double* areas, double* errors,
                                    std::uint8_t* smooth);

}  // namespace lober::detail
