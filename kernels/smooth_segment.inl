// Body of fit_smooth_segments and smooth_chord_areas (kernels/all.inl): fits side by side.
//
// Windows of eight points come in two forms: any of them, or those that begin with consecutive points of a curve, whose
// chords and turns are computed once for all windows that have them. Both forms give the same bits.
#pragma once

#include "kernels/point.hpp"
#include "kernels/smooth_fit.inl"
#include "kernels/smooth_segment.hpp"

namespace lober::detail {
namespace {

// Windows anywhere.
struct AnyWindows {
  Values x_[8], y_[8], along_x_[7], along_y_[7], length_[7], sine_[8];
  ValueMask corner_[8];

  LOBER_INLINE explicit AnyWindows(const Point* const* from) {
    for (std::size_t k = 0; k < 8; k += 2) {
      for (std::size_t lane = 0; lane < value_lanes; lane += lanes) {
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

// One window a lane. Returns whether a chord of any window has no length.
inline bool fit_windows(const Point* const* windows, std::size_t count, SmoothSegment* segments) {
  static_assert(offsetof(SmoothSegment, f) == 2 * sizeof(double), "a shape begins with its chord and coefficients");
  ValueMask no_length{};
  for (std::size_t begin = 0; begin < count; begin += value_lanes) {
    const std::size_t together = count - begin < value_lanes ? count - begin : value_lanes;
    const Point* from[value_lanes];
    double* to[value_lanes];
    for (std::size_t k = 0; k < value_lanes; ++k) {
      const std::size_t number = begin + (k < together ? k : together - 1);
      from[k] = windows[number];
      to[k] = &segments[number].chord.x;
    }
    const AnyWindows w(from);
    for (const Values& length : w.length_) no_length |= length == all_of(0);
    const InUse in_use = find_in_use(w);
    Fits fits;
    constexpr unsigned all = (1U << value_lanes) - 1;
    unsigned smooth = bits_of(in_use.all() & ~wavers(w, in_use) & (w.length_[3] > all_of(0))), noisy = 0;
    if (smooth == all) {
      fits = fit_together<true>(w, in_use);
      smooth = bits_of(fits.smooth);
    }
    if (smooth != all) {
      fits = fit_together<false>(w, in_use);
      smooth = bits_of(fits.smooth);
      noisy = bits_of(fits.noisy);
    }
    Values columns[8] = {w.along_x_[3], w.along_y_[3], all_of(0), fits.f[0],
                         fits.f[1],     fits.f[2],     fits.f[3], fits.f[4]};
    store_rows(columns, to, together);
    alignas(64) double errors[value_lanes];
    store_values(errors, fits.error);
    for (std::size_t k = 0; k < together; ++k) {
      SmoothSegment& segment = segments[begin + k];
      segment.error = errors[k];
      segment.kind = (smooth >> k & 1) != 0  ? SmoothSegment::Kind::smooth
                     : (noisy >> k & 1) != 0 ? SmoothSegment::Kind::noisy
                                             : SmoothSegment::Kind::straight;
    }
  }
  return bits_of(no_length) != 0;
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
  alignas(64) double turns[size + value_lanes];
  BitRow corner, zero, flip, negative, usable_by[3];  // those of chords one, two and three apart

  [[nodiscard]] LOBER_INLINE const double* turn(std::size_t k) const { return turns + value_lanes + k; }

  // Whether a chord has no length; then nothing else is computed.
  inline bool measure(const Point* points, std::size_t count) {
    const std::size_t all = count + 7,
                      padded = (count + 6 + value_lanes - 1) / value_lanes * value_lanes + 2 * value_lanes;
    for (std::size_t k = 0; k < all; ++k) {
      x[k] = points[k].x;
      y[k] = points[k].y;
    }
    for (std::size_t k = all; k < padded; ++k) {  // onwards
      x[k] = x[k - 1] + (x[all - 1] - x[all - 2]);
      y[k] = y[k - 1] + (y[all - 1] - y[all - 2]);
    }
    ValueMask no_length{};
    const std::size_t chords = padded - value_lanes;
    for (std::size_t k = 0; k < chords; k += value_lanes) {
      const Values dx = values_at(&x[k + 1]) - values_at(&x[k]), dy = values_at(&y[k + 1]) - values_at(&y[k]);
      const Values long_ones = root_of(dx * dx + dy * dy);
      store_values(&along_x[k], dx);
      store_values(&along_y[k], dy);
      store_values(&length[k], long_ones);
      if (k + value_lanes <= count + 6) no_length |= long_ones == all_of(0);
    }
    bool any = bits_of(no_length) != 0;
    for (std::size_t k = (count + 6) / value_lanes * value_lanes; k < count + 6; ++k) any |= length[k] == 0;
    if (any) return true;
    for (std::size_t k = chords; k < chords + value_lanes; ++k) along_x[k] = along_y[k] = length[k] = 0;
    for (BitRow* row : {&corner, &zero, &negative, &usable_by[0], &usable_by[1], &usable_by[2]}) row->clear();
    for (std::size_t k = 0; k < value_lanes; ++k) turns[k] = 0;
    for (std::size_t k = 0; k < chords; k += value_lanes) {
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
      store_values(&turns[value_lanes + k], sine);
      corner.set_group(k, sharp_turn(ax, ay, bx, by, lengths));
      zero.set_group(k, sine == all_of(0));
      negative.set_group(k, sine < all_of(0));
    }
    store_values(&turns[value_lanes + chords], all_of(0));
    for (std::size_t k = 0; k < chords; k += value_lanes) {
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
    for (std::size_t k = 0; k < few; k += value_lanes) {
      if (k % 64 == 0) {
        regular = part.regular(k / 64);
        farther = part.farther(k / 64);
      }
      const std::size_t together = few - k < value_lanes ? few - k : value_lanes;
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
      if (together == value_lanes) {
        store_values(areas + begin + k, fits.area);
        store_values(errors + begin + k, fits.error);
        for (std::size_t lane = 0; lane < value_lanes; lane += lanes) {
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
