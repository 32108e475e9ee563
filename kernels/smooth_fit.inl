// The fits of kernels/smooth_segment.inl: smooth segments through windows of eight points, side by side.
#pragma once

#include "kernels/smooth_segment.hpp"
#include "kernels/values.inl"

namespace lober::detail {
namespace {

// Chord k of a window leads from its point k to the next, turn k is the one at point k. Chord j and the `apart`-th
// after it are usable for each other's fit where neither is much longer and they lead much the same way.
LOBER_INLINE ValueMask usable(Values ax, Values ay, Values a, Values bx, Values by, Values b, int apart) {
  const Values uneven = all_of(SmoothLimits::uneven * (1 << (apart - 1)));
  return (a <= uneven * b) & (b <= uneven * a) & (ax * bx + ay * by > all_of(SmoothLimits::cosine_of_stray) * (a * b));
}
LOBER_INLINE ValueMask sharp_turn(Values ax, Values ay, Values bx, Values by, Values lengths) {
  return ~(ax * bx + ay * by > all_of(SmoothLimits::cosine_of_corner) * lengths);
}
LOBER_INLINE Values sine_of_turn(Values ax, Values ay, Values bx, Values by, Values lengths) {
  return select(lengths > all_of(0), (ax * by - ay * bx) / lengths, all_of(0));
}
LOBER_INLINE ValueMask outstanding_turn(Values before, Values turn, Values after) {
  return magnitude_of(turn) > all_of(SmoothLimits::outstanding) * greater(magnitude_of(before), magnitude_of(after));
}

// The vertices whose demands are met, and the two that tell how much the others leave open.
struct InUse {
  ValueMask left[2], right[2];  // the nearest and the next one on either side
  ValueMask farther;            // the third ones, where all of those are in use
  [[nodiscard]] LOBER_INLINE ValueMask all() const { return left[1] & right[1]; }
};

struct Fits {
  Values area, error;  // chord_area(1) and its error
  Values f[5];         // coefficients of u, ..., u^5
  ValueMask smooth, noisy;
};

// Whether turns change sign too often: those between the vertices in use more than once, or all more than twice; a turn
// of zero has none.
template <typename Window>
LOBER_INLINE ValueMask wavers(const Window& w, const InUse& in_use) {
  const ValueMask none{},
      whole = ~none,
      within[8] = {none, none, in_use.left[1], in_use.left[0], in_use.right[0], in_use.right[1], none, none};
  ValueMask of_all = none, of_some = none, last_of_all = none, last_of_some = none;
  const auto count = [](ValueMask sign, ValueMask& last, ValueMask& changes) {
    const ValueMask has_one = sign != 0;
    changes -= has_one & (last == -sign);
    last = (sign & has_one) | (last & ~has_one);
  };
  for (std::size_t k = 1; k < 7; ++k) {
    const Values sine = w.sine(k);
    const ValueMask sign = (sine < all_of(0)) - (sine > all_of(0));
    count(sign & whole, last_of_all, of_all);
    count(sign & within[k], last_of_some, of_some);
  }
  return (of_some > 1) | (of_all > 2);
}

// Twice the area, in units of the segment's square, between a segment and the parabola that touches the lines of the
// chords beside it, which meet no farther away than the longer of these is long. Zero but where a curve that goes on
// turning one way may have its spike, which polygons show as one corner or two.
template <typename Window>
LOBER_INLINE Values area_of_spike(const Window& w) {
  ValueMask left = ~ValueMask{}, right = left;
  for (std::size_t k = 2; k < 6; ++k) {
    left &= w.sine(k) > all_of(0);
    right &= w.sine(k) < all_of(0);
  }
  const auto turn = [&](std::size_t k) { return magnitude_of(w.sine(k)); };
  const auto falls_to = [&](std::size_t k, std::size_t next, double times) {
    return ~w.corner(next) & (turn(k) < all_of(times) * turn(next));
  };
  constexpr double two = SmoothLimits::two_corners_of_spike, one = SmoothLimits::corner_of_spike;
  const ValueMask between_corners =
      w.corner(3) & w.corner(4) & falls_to(3, 2, two) & falls_to(4, 2, two) & falls_to(3, 5, two) & falls_to(4, 5, two);
  const ValueMask beside_corner = (w.corner(3) & falls_to(3, 4, one)) | (w.corner(4) & falls_to(4, 3, one));
  const auto cotangent = [&](std::size_t k) {
    const Values ax = w.along_x(k - 1), ay = w.along_y(k - 1), bx = w.along_x(k), by = w.along_y(k);
    return (ax * bx + ay * by) / magnitude_of(ax * by - ay * bx);
  };
  const Values least = w.length(3) / greater(w.length(2), w.length(4));
  const Values area = all_of(2.0 / 3) / greater(cotangent(3) + cotangent(4), least);
  return select((left | right) & (between_corners | beside_corner), area, all_of(0));
}

// The fits. `regular`: both vertices on either side are in use in all of these windows, and no turns waver.
template <bool regular, typename Window>
LOBER_INLINE Fits fit_together(const Window& w, const InUse& in_use) {
  const Values x = w.along_x(3), y = w.along_y(3), own = w.length(3), square = own * own, inverse = all_of(1) / square;
  const ValueMask active[4] = {in_use.left[0], in_use.right[0], in_use.left[1], in_use.right[1]};
  constexpr std::size_t vertices[6] = {2, 5, 1, 6, 0, 7};
  constexpr double area_of_power[6] = {2.0 / 6, 2.0 / 12, 2.0 / 20, 2.0 / 30, 2.0 / 42, 2.0 / 56};
  const Values from_x = w.x(3), from_y = w.y(3), zero = all_of(0), one = all_of(1);

  // Values of g that the vertices demand, by Newton's form: divided[k] times the product of u - u[j], j < k. A vertex
  // that is not in use has a divided difference of zero, and a factor of one. Quotients do not wait for one another.
  Values u[6], height[6], ends[6], factor[6][6], quotient[6], divided[6], largest = zero;
#pragma GCC unroll 6
  for (std::size_t k = 0; k < 6; ++k) {
    const Values away_x = w.x(vertices[k]) - from_x, away_y = w.y(vertices[k]) - from_y;
    u[k] = (away_x * x + away_y * y) * inverse;
    height[k] = (x * away_y - y * away_x) * inverse;
    ends[k] = u[k] * (u[k] - one);
    Values product = ends[k];
#pragma GCC unroll 6
    for (std::size_t j = 0; j < k; ++j) {
      factor[k][j] = u[k] - u[j];
      if (!regular && j < 4) factor[k][j] = select(active[j], factor[k][j], one);
      product *= factor[k][j];
    }
    quotient[k] = one / product;
  }
#pragma GCC unroll 6
  for (std::size_t k = 0; k < 6; ++k) {
    Values sum = k > 0 ? divided[k - 1] : zero;
#pragma GCC unroll 6
    for (std::size_t j = 1; j < k; ++j) sum = divided[k - 1 - j] + factor[k][k - 1 - j] * sum;
    divided[k] = k > 0 ? (height[k] - sum * ends[k]) * quotient[k] : height[k] * quotient[k];
    if (regular || k > 3) continue;
    divided[k] = select(active[k], divided[k], zero);
    largest = greater(largest, select(active[k], magnitude_of(height[k] / ends[k]), zero));
  }

  // The coefficients of those products, whose areas say how much each vertex changes.
  Values power[5] = {one, zero, zero, zero, zero}, share[4], fifth = zero, sixth = zero;
#pragma GCC unroll 4
  for (std::size_t k = 0; k < 4; ++k) {
    share[k] = all_of(area_of_power[0]) * power[0];
#pragma GCC unroll 4
    for (std::size_t m = 1; m <= k; ++m) share[k] += all_of(area_of_power[m]) * power[m];
    share[k] *= divided[k];
#pragma GCC unroll 5
    for (std::size_t m = k + 1; m > 0; --m) {
      const Values next = m == k + 1 ? power[k] : power[m - 1] - u[k] * power[m];
      power[m] = regular ? next : select(active[k], next, power[m]);
    }
    power[0] = regular ? -u[k] * power[0] : select(active[k], -u[k] * power[0], power[0]);
  }
#pragma GCC unroll 5
  for (std::size_t m = 0; m < 5; ++m) {
    fifth += all_of(area_of_power[m]) * power[m];
    sixth += all_of(area_of_power[m + 1]) * power[m];
  }
  const Values farther_change = magnitude_of(divided[4] * fifth + divided[5] * (sixth - u[4] * fifth));

  // g = g[0] + ... + g[3] u^3
  Values g[4] = {divided[3], zero, zero, zero};
#pragma GCC unroll 3
  for (std::size_t last = 1; last < 4; ++last) {
    const std::size_t k = 3 - last;
#pragma GCC unroll 3
    for (std::size_t m = last; m > 0; --m) {
      const Values next = m == last ? g[m - 1] : g[m - 1] - u[k] * g[m];
      g[m] = regular ? next : select(active[k], next, g[m]);
    }
    const Values next = divided[k] - u[k] * g[0];
    g[0] = regular ? next : select(active[k], next, g[0]);
  }
  Fits fits;
  fits.f[0] = -g[0];
#pragma GCC unroll 3
  for (std::size_t m = 1; m < 4; ++m) fits.f[m] = g[m - 1] - g[m];
  fits.f[4] = g[3];
  const Values area =
      fits.f[1] * all_of(1.0 / 3) + (fits.f[2] * all_of(0.5) + (fits.f[3] * all_of(0.6) + fits.f[4] * all_of(2.0 / 3)));
  fits.area = (x * x + y * y) * area;

  // The changes of the vertices that came last: the third and the fourth, or the only one of one or two, or of three.
  const auto turn_at = [&](std::size_t k) { return select(w.corner(k), zero, magnitude_of(w.sine(k))); };
  ValueMask count{};
  Values change = zero;
  if constexpr (regular) {
    change = magnitude_of(share[2] + share[3]);
  } else {
    for (const ValueMask& one_more : active) count -= one_more;
    const ValueMask kept = (count > 2) & 2, least = (kept != 0) ? kept : count - 1;
    ValueMask rank{};
    for (std::size_t k = 0; k < 4; ++k) {
      change += select(active[k] & (rank >= least), share[k], zero);
      rank -= active[k];
    }
    change = magnitude_of(change);
  }
  const Values next = greater(all_of(3) * farther_change, change * change / magnitude_of(area));
  Values unknown = select(in_use.farther & (next < change), next, change);
  if constexpr (!regular) {
    const Values larger = greater(turn_at(3), turn_at(4));
    const Values of_few = all_of(3) * greater(change, larger * larger * magnitude_of(area));
    unknown = select(count < 4, of_few, unknown);
  }
  fits.error = square * (unknown + all_of(0x1p-50)) +
               own * (all_of(SmoothLimits::rounding) * greater(magnitude_of(from_x), magnitude_of(from_y)));
  fits.smooth = (magnitude_of(g[0]) < one) & (magnitude_of(g[0] + g[1] + g[2] + g[3]) < one);
  if constexpr (!regular) {
    const ValueMask straight = count == 0, has_length = own > zero;
    fits.smooth &= ~(straight | wavers(w, in_use)) & has_length;
    fits.noisy = ~(fits.smooth | straight) & has_length;
    // The area that a curve encloses whose turns at its ends all take place along it, corners apart.
    const Values of_turns = square * (turn_at(3) + turn_at(4)) * all_of(1.0 / 6);
    fits.error = select(fits.noisy, fits.error + square * largest * all_of(1.0 / 3), fits.error);
    fits.error = select(has_length, select(straight, of_turns, fits.error), zero);
    fits.area = select(fits.smooth, fits.area, zero);
    const Values spike = square * area_of_spike(w);
    fits.error = select(has_length & (spike > zero), greater(fits.error, magnitude_of(spike - magnitude_of(fits.area))),
                        fits.error);
    for (Values& coefficient : fits.f) coefficient = select(fits.smooth, coefficient, zero);
  }
  return fits;
}

}  // namespace
}  // namespace lober::detail
