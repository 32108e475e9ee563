// Body of smooth_chord_areas (kernels/all.inl): fit_smooth_segment, four segments at a time.
#pragma once

#include "kernels/point.hpp"
#include "kernels/simd.hpp"
#include "kernels/smooth_segment.hpp"

namespace lober::detail {
namespace {

constexpr std::size_t fits_at_once = 256;

// Points, chords and turns of a stretch of curve, each computed once where the windows of eight segments have it.
struct Stretch {
  static constexpr std::size_t size = fits_at_once + 12;
  double x[size]{}, y[size]{};                              // coordinates of the points
  double along_x[size]{}, along_y[size]{}, length[size]{};  // direction and length of the chord from each point on
  double sine[size]{};                                      // sine of the turn at each point
  std::int64_t corner[size]{};                              // whether it is a corner, as a mask
};

LOBER_INLINE Lanes greater(Lanes a, Lanes b) {
  return a < b ? b : a;
}

inline void measure_stretch(const Point* points, std::size_t count, Stretch& stretch) {
  for (std::size_t k = 0; k < count + 7; ++k) {
    stretch.x[k] = points[k].x;
    stretch.y[k] = points[k].y;
  }
  for (std::size_t k = 0; k < count + 6; k += lanes) {
    const Lanes x = load(&stretch.x[k + 1]) - load(&stretch.x[k]), y = load(&stretch.y[k + 1]) - load(&stretch.y[k]);
    store(&stretch.along_x[k], x);
    store(&stretch.along_y[k], y);
    store(&stretch.length[k], square_root(x * x + y * y));
  }
  LaneMask sharp[Stretch::size / lanes];
  for (std::size_t k = 1; k < count + 6; k += lanes) {
    const Lanes ax = load(&stretch.along_x[k - 1]), ay = load(&stretch.along_y[k - 1]);
    const Lanes bx = load(&stretch.along_x[k]), by = load(&stretch.along_y[k]);
    const Lanes lengths = load(&stretch.length[k - 1]) * load(&stretch.length[k]);
    sharp[k / lanes] = ~(ax * bx + ay * by > splat(SmoothLimits::cosine_of_corner) * lengths);
    store(&stretch.sine[k], lengths > splat(0) ? (ax * by - ay * bx) / lengths : splat(0));
  }
  for (std::size_t k = 1; k < count + 6; k += lanes) {
    const Lanes beside = greater(absolute(load(&stretch.sine[k - 1])), absolute(load(&stretch.sine[k + 1])));
    const LaneMask corner =
        sharp[k / lanes] | (absolute(load(&stretch.sine[k])) > splat(SmoothLimits::outstanding) * beside);
    __builtin_memcpy(&stretch.corner[k], &corner, sizeof corner);
  }
}

// The demands of the vertices beside four segments, and the areas that follow; see fit_smooth_segment, which each step
// is from. Bit k is set where it is that of segment k: both vertices on either side are of use, and nothing is noise.
inline unsigned fit_four(const Stretch& stretch, std::size_t at, Lanes& area, Lanes& error) {
  const auto corner = [&](std::size_t k) {
    LaneMask mask;
    __builtin_memcpy(&mask, &stretch.corner[at + k], sizeof mask);
    return mask;
  };
  const Lanes x = load(&stretch.along_x[at + 3]), y = load(&stretch.along_y[at + 3]);
  const Lanes own = load(&stretch.length[at + 3]), square = own * own;
  LaneMask of_use = ~(corner(2) | corner(3) | corner(4) | corner(5));
  const auto require_usable = [&](std::size_t k, double unevenness) {
    const Lanes other = load(&stretch.length[at + k]);
    const Lanes both = load(&stretch.along_x[at + k]) * x + load(&stretch.along_y[at + k]) * y;
    of_use &= (other <= splat(unevenness) * own) & (own <= splat(unevenness) * other) &
              (both > splat(SmoothLimits::cosine_of_stray) * own * other);
  };
  require_usable(2, SmoothLimits::uneven);
  require_usable(1, 2 * SmoothLimits::uneven);
  require_usable(4, SmoothLimits::uneven);
  require_usable(5, 2 * SmoothLimits::uneven);
  // Turns that change sign; one of zero has none.
  LaneMask within{}, in_all{}, negative[7];
  for (std::size_t k = 1; k < 7; ++k) {
    const Lanes sine = load(&stretch.sine[at + k]);
    of_use &= sine != splat(0);
    negative[k] = sine < splat(0);
    if (k > 1) in_all -= negative[k] ^ negative[k - 1];
    if (k > 2 && k < 6) within -= negative[k] ^ negative[k - 1];
  }
  of_use &= (within <= 1) & (in_all <= 2);
  if (mask_bits(of_use) == 0) return 0;

  // The vertices that tell how much the others leave open.
  const LaneMask of_use_so_far = of_use;
  require_usable(0, 4 * SmoothLimits::uneven);
  require_usable(6, 4 * SmoothLimits::uneven);
  const LaneMask farther = of_use;
  of_use = of_use_so_far;

  Lanes u[6], divided[6];
  const Lanes from_x = load(&stretch.x[at + 3]), from_y = load(&stretch.y[at + 3]);
  constexpr std::size_t vertices[6] = {2, 5, 1, 6, 0, 7};
  for (std::size_t k = 0; k < 6; ++k) {
    const Lanes away_x = load(&stretch.x[at + vertices[k]]) - from_x;
    const Lanes away_y = load(&stretch.y[at + vertices[k]]) - from_y;
    u[k] = (away_x * x + away_y * y) / square;
    Lanes value = (x * away_y - y * away_x) / square / (u[k] * (u[k] - splat(1)));
    for (std::size_t j = 0; j < k; ++j) value = (value - divided[j]) / (u[k] - u[j]);
    divided[k] = value;
  }
  Lanes g[4]{}, less[4]{};
  const auto add = [&](Lanes(&to)[4], std::size_t k) {
    for (std::size_t power = 3; power > 0; --power) to[power] = to[power - 1] - u[k] * to[power];
    to[0] = divided[k] - u[k] * to[0];
  };
  for (std::size_t k = 4; k-- > 0;) add(g, k);
  for (std::size_t k = 2; k-- > 0;) add(less, k);
  const auto area_of = [](const Lanes(&of)[4]) {
    return splat(2) * (of[0] / splat(6) + of[1] / splat(12) + of[2] / splat(20) + of[3] / splat(30));
  };
  Lanes w[5]{splat(1)};
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t power = 4; power > 0; --power) w[power] = w[power - 1] - u[k] * w[power];
    w[0] = -u[k] * w[0];
  }
  constexpr double areas_of_powers[5] = {6, 12, 20, 30, 42};
  Lanes fifth = w[4] / splat(42), sixth = w[4] / splat(56);
  for (std::size_t power = 4; power-- > 0;) {
    fifth += w[power] / splat(areas_of_powers[power]);
    sixth += w[power] / splat(areas_of_powers[power + 1]);
  }
  const Lanes change_of_area = splat(2) * (divided[4] * fifth + divided[5] * (sixth - u[4] * fifth));
  const Lanes whole = area_of(g), change = absolute(whole - area_of(less));
  const Lanes next = greater(splat(3) * absolute(change_of_area), change * change / absolute(whole));
  const LaneMask better = farther & (next < change);
  error = square * ((better ? next : change) + splat(0x1p-50)) +
          own * (splat(SmoothLimits::rounding) * greater(absolute(from_x), absolute(from_y)));
  of_use &= (absolute(g[0]) < splat(1)) & (absolute(g[0] + g[1] + g[2] + g[3]) < splat(1));
  const Lanes f2 = g[0] - g[1], f3 = g[1] - g[2], f4 = g[2] - g[3], f5 = g[3];
  area = (x * x + y * y) * (f2 / splat(3) + (f3 / splat(2) + (f4 * splat(0.6) + f5 * splat(2.0 / 3))));
  return mask_bits(of_use);
}

inline void fit_all(const Point* points, std::size_t count, double* areas, double* errors, std::uint8_t* fitted) {
  Stretch stretch;
  for (std::size_t begin = 0; begin < count; begin += fits_at_once) {
    const std::size_t few = count - begin < fits_at_once ? count - begin : fits_at_once;
    measure_stretch(points + begin, few, stretch);
    for (std::size_t k = 0; k < few; k += lanes) {
      Lanes area{}, error{};
      const unsigned bits = fit_four(stretch, k, area, error);
      for (std::size_t lane = 0; lane < lanes && k + lane < few; ++lane) {
        areas[begin + k + lane] = area[lane];
        errors[begin + k + lane] = error[lane];
        fitted[begin + k + lane] = (bits >> lane & 1) != 0;
      }
    }
  }
}

}  // namespace
}  // namespace lober::detail
