// Body of fit_smooth_segments and smooth_chord_areas (kernels/all.inl): fits side by side.
//
// Windows of eight points come in two forms: any of them, or those that begin with consecutive points of a curve, whose
// chords and turns are computed once for all windows that have them. Both forms give the same bits.
#pragma once

#include "kernels/point.hpp"
#include "kernels/simd.hpp"
#include "kernels/smooth_segment.hpp"

namespace lober::detail {
namespace {

// Fits are computed side by side in as many lanes as the instruction set has.
#ifdef __AVX512F__
constexpr std::size_t fit_lanes = 8;
#else
constexpr std::size_t fit_lanes = lanes;
#endif
using Values = double __attribute__((vector_size(8 * fit_lanes)));
using ValueMask = std::int64_t __attribute__((vector_size(8 * fit_lanes)));

LOBER_INLINE Values values_at(const double* from) {
  Values values;
  __builtin_memcpy(&values, from, sizeof values);
  return values;
}
LOBER_INLINE void store_values(double* to, Values values) {
  __builtin_memcpy(to, &values, sizeof values);
}
LOBER_INLINE Values all_of(double value) {
  return value - Values{};
}
LOBER_INLINE Values magnitude_of(Values a) {
  return __builtin_bit_cast(Values, __builtin_bit_cast(ValueMask, a) & 0x7fffffffffffffff);
}
LOBER_INLINE Values greater(Values a, Values b) {
  return a < b ? b : a;
}
LOBER_INLINE Values select(ValueMask mask, Values a, Values b) {
  return mask ? a : b;
}
LOBER_INLINE Values root_of(Values a) {
#ifdef __AVX512F__
  return _mm512_maskz_sqrt_pd(0xff, a);  // the form without a mask makes GCC 12 warn of its own header
#else
  return square_root(a);
#endif
}
// Bit k is that of lane k.
LOBER_INLINE unsigned bits_of(ValueMask mask) {
#ifdef __AVX512F__
  return _mm512_movepi64_mask(__builtin_bit_cast(__m512i, mask));
#else
  return mask_bits(mask);
#endif
}
LOBER_INLINE ValueMask mask_of(unsigned bits) {
#ifdef __AVX512F__
  return __builtin_bit_cast(ValueMask, _mm512_movm_epi64(static_cast<__mmask8>(bits)));
#else
  const auto all = static_cast<std::int64_t>(bits);
  return (ValueMask{all, all, all, all} & ValueMask{1, 2, 4, 8}) != 0;
#endif
}

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
    for (Values& coefficient : fits.f) coefficient = select(fits.smooth, coefficient, zero);
  }
  return fits;
}

// Windows anywhere.
struct AnyWindows {
  Values x_[8], y_[8], along_x_[7], along_y_[7], length_[7], sine_[8];
  ValueMask corner_[8];

  LOBER_INLINE explicit AnyWindows(const Point* const* from) {
    for (std::size_t k = 0; k < 8; k += 2) {
      for (std::size_t lane = 0; lane < fit_lanes; lane += lanes) {
        Lanes rows[lanes];
        for (std::size_t m = 0; m < lanes; ++m) rows[m] = load(&from[lane + m][k].x);
        transpose(rows);
        Values* const to[lanes] = {&x_[k], &y_[k], &x_[k + 1], &y_[k + 1]};
        for (std::size_t m = 0; m < lanes; ++m) {
          __builtin_memcpy(reinterpret_cast<char*>(to[m]) + lane * sizeof(double), &rows[m], sizeof rows[m]);
        }
      }
    }
    for (std::size_t k = 0; k < 7; ++k) {
      along_x_[k] = x_[k + 1] - x_[k];
      along_y_[k] = y_[k + 1] - y_[k];
      length_[k] = root_of(along_x_[k] * along_x_[k] + along_y_[k] * along_y_[k]);
    }
    sine_[0] = sine_[7] = all_of(0);
    for (std::size_t k = 1; k < 7; ++k) {
      const Values lengths = length_[k - 1] * length_[k];
      sine_[k] = sine_of_turn(along_x_[k - 1], along_y_[k - 1], along_x_[k], along_y_[k], lengths);
      corner_[k] = sharp_turn(along_x_[k - 1], along_y_[k - 1], along_x_[k], along_y_[k], lengths);
    }
    for (std::size_t k = 2; k < 6; ++k) corner_[k] |= outstanding_turn(sine_[k - 1], sine_[k], sine_[k + 1]);
  }
  [[nodiscard]] LOBER_INLINE Values x(std::size_t k) const { return x_[k]; }
  [[nodiscard]] LOBER_INLINE Values y(std::size_t k) const { return y_[k]; }
  [[nodiscard]] LOBER_INLINE Values along_x(std::size_t k) const { return along_x_[k]; }
  [[nodiscard]] LOBER_INLINE Values along_y(std::size_t k) const { return along_y_[k]; }
  [[nodiscard]] LOBER_INLINE Values length(std::size_t k) const { return length_[k]; }
  [[nodiscard]] LOBER_INLINE Values sine(std::size_t k) const { return sine_[k]; }
  [[nodiscard]] LOBER_INLINE ValueMask corner(std::size_t k) const { return corner_[k]; }
  [[nodiscard]] LOBER_INLINE ValueMask usable_by_own(std::size_t k) const {
    const int apart = k < 3 ? 3 - static_cast<int>(k) : static_cast<int>(k) - 3;
    return usable(along_x_[k], along_y_[k], length_[k], along_x_[3], along_y_[3], length_[3], apart);
  }
};

template <typename Window>
LOBER_INLINE InUse find_in_use(const Window& w) {
  InUse in_use;
  in_use.left[0] = ~w.corner(3) & w.usable_by_own(2);
  in_use.left[1] = in_use.left[0] & ~w.corner(2) & w.usable_by_own(1);
  in_use.right[0] = ~w.corner(4) & w.usable_by_own(4);
  in_use.right[1] = in_use.right[0] & ~w.corner(5) & w.usable_by_own(5);
  in_use.farther = in_use.all() & w.usable_by_own(0) & w.usable_by_own(6);
  return in_use;
}

// Windows as they lie in memory; one lane each.
inline void fit_windows(const Point* const* windows, std::size_t count, SmoothSegment* segments) {
  for (std::size_t begin = 0; begin < count; begin += fit_lanes) {
    const std::size_t together = count - begin < fit_lanes ? count - begin : fit_lanes;
    const Point* from[fit_lanes];
    for (std::size_t k = 0; k < fit_lanes; ++k) from[k] = windows[begin + (k < together ? k : together - 1)];
    const AnyWindows w(from);
    const Fits fits = fit_together<false>(w, find_in_use(w));
    const unsigned smooth = bits_of(fits.smooth), noisy = bits_of(fits.noisy);
    for (std::size_t k = 0; k < together; ++k) {
      SmoothSegment& to = segments[begin + k];
      to.chord = {w.along_x_[3][k], w.along_y_[3][k]};
      to.f[0] = 0;
      for (std::size_t m = 0; m < 5; ++m) to.f[m + 1] = fits.f[m][k];
      to.error = fits.error[k];
      to.kind = (smooth >> k & 1) != 0  ? SmoothSegment::Kind::smooth
                : (noisy >> k & 1) != 0 ? SmoothSegment::Kind::noisy
                                        : SmoothSegment::Kind::straight;
    }
  }
}

constexpr std::size_t fits_at_once = 256;

// A bit for each of fits_at_once and a few more.
struct BitRow {
  static constexpr std::size_t words = fits_at_once / 64 + 2;
  std::uint64_t word[words];

  LOBER_INLINE void clear() {
    for (std::uint64_t& bits : word) bits = 0;
  }
  LOBER_INLINE void set_group(std::size_t at, ValueMask mask) {
    word[at / 64] |= static_cast<std::uint64_t>(bits_of(mask)) << at % 64;
  }
  // 64 bits from 64 w + shift on.
  [[nodiscard]] LOBER_INLINE std::uint64_t from(std::size_t w, unsigned shift) const {
    return shift == 0 ? word[w] : word[w] >> shift | word[w + 1] << (64 - shift);
  }
};

// Points of a part of a curve, its chords, each from the point of the same number, its turns, each at the point after
// that, and where neighbours are usable.
struct CurvePart {
  static constexpr std::size_t size = fits_at_once + 24;
  alignas(64) double x[size], y[size];
  alignas(64) double along_x[size], along_y[size], length[size];
  alignas(64) double turns[size + fit_lanes];
  BitRow corner, zero, flip, negative, usable_by[3];  // those of chords one, two and three apart

  [[nodiscard]] LOBER_INLINE const double* turn(std::size_t k) const { return turns + fit_lanes + k; }

  // Whether a chord has no length; then nothing else is computed.
  inline bool measure(const Point* points, std::size_t count) {
    const std::size_t all = count + 7, padded = (count + 6 + fit_lanes - 1) / fit_lanes * fit_lanes + 2 * fit_lanes;
    for (std::size_t k = 0; k < all; ++k) {
      x[k] = points[k].x;
      y[k] = points[k].y;
    }
    for (std::size_t k = all; k < padded; ++k) {  // onwards
      x[k] = x[k - 1] + (x[all - 1] - x[all - 2]);
      y[k] = y[k - 1] + (y[all - 1] - y[all - 2]);
    }
    ValueMask no_length{};
    const std::size_t chords = padded - fit_lanes;
    for (std::size_t k = 0; k < chords; k += fit_lanes) {
      const Values dx = values_at(&x[k + 1]) - values_at(&x[k]), dy = values_at(&y[k + 1]) - values_at(&y[k]);
      const Values long_ones = root_of(dx * dx + dy * dy);
      store_values(&along_x[k], dx);
      store_values(&along_y[k], dy);
      store_values(&length[k], long_ones);
      if (k + fit_lanes <= count + 6) no_length |= long_ones == all_of(0);
    }
    bool any = bits_of(no_length) != 0;
    for (std::size_t k = (count + 6) / fit_lanes * fit_lanes; k < count + 6; ++k) any |= length[k] == 0;
    if (any) return true;
    for (std::size_t k = chords; k < chords + fit_lanes; ++k) along_x[k] = along_y[k] = length[k] = 0;
    for (BitRow* row : {&corner, &zero, &negative, &usable_by[0], &usable_by[1], &usable_by[2]}) row->clear();
    for (std::size_t k = 0; k < fit_lanes; ++k) turns[k] = 0;
    for (std::size_t k = 0; k < chords; k += fit_lanes) {
      const Values ax = values_at(&along_x[k]), ay = values_at(&along_y[k]), a = values_at(&length[k]);
      const auto compare = [&](int apart) {
        const auto after = k + static_cast<std::size_t>(apart);
        return usable(ax, ay, a, values_at(&along_x[after]), values_at(&along_y[after]), values_at(&length[after]),
                      apart);
      };
      for (int apart = 1; apart <= 3; ++apart) usable_by[apart - 1].set_group(k, compare(apart));
      const Values bx = values_at(&along_x[k + 1]), by = values_at(&along_y[k + 1]),
                   lengths = a * values_at(&length[k + 1]);
      const Values sine = sine_of_turn(ax, ay, bx, by, lengths);
      store_values(&turns[fit_lanes + k], sine);
      corner.set_group(k, sharp_turn(ax, ay, bx, by, lengths));
      zero.set_group(k, sine == all_of(0));
      negative.set_group(k, sine < all_of(0));
    }
    store_values(&turns[fit_lanes + chords], all_of(0));
    for (std::size_t k = 0; k < chords; k += fit_lanes) {
      corner.set_group(k, outstanding_turn(values_at(turn(k) - 1), values_at(turn(k)), values_at(turn(k) + 1)));
    }
    std::uint64_t before = 0;
    for (std::size_t w = 0; w < BitRow::words; ++w) {
      flip.word[w] = negative.word[w] ^ (negative.word[w] << 1 | before >> 63);
      before = negative.word[w];
    }
    return false;
  }

  // Bit k: both vertices on either side of segment 64 w + k are in use, and turns do not waver.
  [[nodiscard]] LOBER_INLINE std::uint64_t regular(std::size_t w) const {
    std::uint64_t corners = 0, zeros = 0;
    for (unsigned k = 1; k < 5; ++k) corners |= corner.from(w, k);
    for (unsigned k = 0; k < 6; ++k) zeros |= zero.from(w, k);
    const std::uint64_t near_by =
        usable_by[0].from(w, 2) & usable_by[0].from(w, 3) & usable_by[1].from(w, 1) & usable_by[1].from(w, 3);
    const std::uint64_t a = flip.from(w, 2), b = flip.from(w, 3), c = flip.from(w, 4);
    const std::uint64_t twice_within = (a & b) | (a & c) | (b & c);
    const std::uint64_t thrice = (a | b | c) & flip.from(w, 1) & flip.from(w, 5);
    return near_by & ~(corners | zeros | twice_within | thrice);
  }
  [[nodiscard]] LOBER_INLINE std::uint64_t farther(std::size_t w) const {
    return usable_by[2].from(w, 0) & usable_by[2].from(w, 3);
  }
};

// The windows of the segments at, ..., at + 3 of a part.
struct WindowsOfPart {
  const CurvePart& part;
  std::size_t at;
  [[nodiscard]] LOBER_INLINE Values x(std::size_t k) const { return values_at(&part.x[at + k]); }
  [[nodiscard]] LOBER_INLINE Values y(std::size_t k) const { return values_at(&part.y[at + k]); }
  [[nodiscard]] LOBER_INLINE Values along_x(std::size_t k) const { return values_at(&part.along_x[at + k]); }
  [[nodiscard]] LOBER_INLINE Values along_y(std::size_t k) const { return values_at(&part.along_y[at + k]); }
  [[nodiscard]] LOBER_INLINE Values length(std::size_t k) const { return values_at(&part.length[at + k]); }
  [[nodiscard]] LOBER_INLINE Values sine(std::size_t k) const { return values_at(part.turn(at + k - 1)); }
  [[nodiscard]] LOBER_INLINE ValueMask mask(const BitRow& row, std::size_t k) const {
    const std::size_t bit = at + k;
    return mask_of(static_cast<unsigned>(row.from(bit / 64, static_cast<unsigned>(bit % 64))));
  }
  [[nodiscard]] LOBER_INLINE ValueMask corner(std::size_t k) const { return mask(part.corner, k - 1); }
  [[nodiscard]] LOBER_INLINE ValueMask usable_by_own(std::size_t k) const {
    const std::size_t apart = k < 3 ? 3 - k : k - 3;
    return mask(part.usable_by[apart - 1], k < 3 ? k : 3);
  }
};

inline Fits fit_irregular(const CurvePart& part, std::size_t at) {
  const WindowsOfPart w{part, at};
  return fit_together<false>(w, find_in_use(w));
}

inline StraightSegments fit_all(const Point* points, std::size_t count, double* areas, double* errors,
                                std::uint8_t* smooth) {
  CurvePart part;
  StraightSegments straight{0, false};
  for (std::size_t begin = 0; begin < count; begin += fits_at_once) {
    const std::size_t few = count - begin < fits_at_once ? count - begin : fits_at_once;
    if (part.measure(points + begin, few)) return {0, true};
    std::uint64_t regular = 0, farther = 0;
    for (std::size_t k = 0; k < few; k += fit_lanes) {
      if (k % 64 == 0) {
        regular = part.regular(k / 64);
        farther = part.farther(k / 64);
      }
      const std::size_t together = few - k < fit_lanes ? few - k : fit_lanes;
      const unsigned wanted = (1U << together) - 1;
      Fits fits;
      unsigned bits = static_cast<unsigned>(regular >> k % 64) & wanted;
      if (bits == wanted) {
        InUse in_use;
        in_use.farther = mask_of(static_cast<unsigned>(farther >> k % 64));
        fits = fit_together<true>(WindowsOfPart{part, k}, in_use);
        bits = bits_of(fits.smooth) & wanted;
      }
      if (bits != wanted) {
        fits = fit_irregular(part, k);
        bits = bits_of(fits.smooth) & wanted;
        straight.count += together - static_cast<std::size_t>(__builtin_popcount(bits));
      }
      if (together == fit_lanes) {
        store_values(areas + begin + k, fits.area);
        store_values(errors + begin + k, fits.error);
        for (std::size_t lane = 0; lane < fit_lanes; lane += lanes) {
          const std::uint32_t bytes = (bits >> lane & 15U) * 0x204081U & 0x01010101U;
          __builtin_memcpy(smooth + begin + k + lane, &bytes, sizeof bytes);
        }
        continue;
      }
      for (std::size_t lane = 0; lane < together; ++lane) {
        areas[begin + k + lane] = fits.area[lane];
        errors[begin + k + lane] = fits.error[lane];
        smooth[begin + k + lane] = bits >> lane & 1;
      }
    }
  }
  return straight;
}

}  // namespace
}  // namespace lober::detail
