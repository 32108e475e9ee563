// Common parts of the kernels of strips.
#pragma once

#include "kernels/inline.hpp"
#include "kernels/strip.hpp"

namespace lober::detail {

/// The point at p along the middle of a strip of bend b is (p, b p^2). Where its own origin is at (u, v) of another
/// strip's coordinates and its axis at the angle of `cosine` and `sine` there, v - bend u^2 of that point is a
/// polynomial in p with these coefficients. For T = double or Lanes.
template <typename T>
struct StripValue {
  T c0, c1, c2, c3, c4;
};

template <typename T>
LOBER_INLINE void strip_value(T bend, T u, T v, T cosine, T sine, T own_bend, StripValue<T>& value) {
  const T turned = sine * own_bend;
  value.c0 = v - bend * u * u;
  value.c1 = sine - (bend + bend) * u * cosine;
  value.c2 = cosine * own_bend + bend * ((u + u) * turned - cosine * cosine);
  value.c3 = (bend + bend) * cosine * turned;
  value.c4 = -bend * turned * turned;
}

/// The strip along the parabola through `at` with low <= v - bend u^2 <= high and |u| <= far.
LOBER_INLINE void strip_between(Point at, Point along, double bend, double low, double high, double far, Strip& strip) {
  const double shift = 0.5 * (low + high), half = 0.5 * (high - low);
  const double rise = __builtin_fabs(bend) * far * far;
  strip.middle.x = at.x - shift * along.y;
  strip.middle.y = at.y + shift * along.x;
  const double slack =
      0x1p-45 * (__builtin_fabs(strip.middle.x) + __builtin_fabs(strip.middle.y) + far + rise + half) + 0x1p-1000;
  strip.along = along;
  strip.length = far + slack;
  strip.width = half + slack;
  strip.bend = bend;
  strip.reach = rise + half + 4 * slack;
}

/// A direction of no length, or none that can be normalised, becomes the x axis.
LOBER_INLINE void normalise(Point& direction) {
  const double square = direction.x * direction.x + direction.y * direction.y;
  const bool sound = square > 0x1p-960 && square < 0x1p1000;
  const double part = 1 / __builtin_sqrt(sound ? square : 1);
  direction.x = sound ? direction.x * part : 1;
  direction.y = sound ? direction.y * part : 0;
}

/// Strips are nowhere steep: the bend, or none.
LOBER_INLINE double not_steep(double bend, double length) {
  return __builtin_fabs(bend) * length <= 0.9 ? bend : 0;
}

}  // namespace lober::detail
