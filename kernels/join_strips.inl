// Body of join_strips (kernels/all.inl).
#pragma once

#include "kernels/simd.hpp"
#include "kernels/strip_lanes.inl"
#include "kernels/strip_value.hpp"

namespace lober::detail {
namespace {

// A strip in the coordinates of the one that is made.
struct Part {
  Lanes u, v, cosine, sine, far;
};

inline void place_part(const Strips& strip, Lanes x, Lanes y, Lanes ax, Lanes ay, Part& part) {
  const Lanes dx = strip.x - x, dy = strip.y - y;
  part.u = ax * dx + ay * dy;
  part.v = ax * dy - ay * dx;
  part.cosine = ax * strip.ax + ay * strip.ay;
  part.sine = ax * strip.ay - ay * strip.ax;
  part.far = absolute(part.u) + absolute(part.cosine) * strip.length + absolute(part.sine) * strip.reach;
}

// The values of v - bend u^2 on a strip: the polynomial lies between its Bernstein coefficients.
inline void add_part(const Strips& strip, const Part& part, Lanes bend, Lanes& low, Lanes& high) {
  StripValue<Lanes> g;
  strip_value(bend, part.u, part.v, part.cosine, part.sine, strip.bend, g);
  const Lanes length = strip.length, square = length * length;
  const Lanes g1 = g.c1 * length, g2 = g.c2 * square, g3 = g.c3 * length * square, g4 = g.c4 * square * square;
  const Lanes even = g.c0 + g2 + g4, odd = absolute(g1 + g3), inner = g.c0 - g4;
  const Lanes inner_odd = absolute(splat(0.5) * (g1 - g3)), middle = g.c0 - g2 * splat(1.0 / 3) + g4;
  const Lanes aside = absolute(part.cosine) * strip.width +
                      splat(2) * absolute(bend * part.sine) * strip.width * part.far +
                      splat(0x1p-50) * (absolute(g.c0) + absolute(g2) + absolute(g4));
  low = min(low, min(min(even - odd, inner - inner_odd), middle) - aside);
  high = max(high, max(max(even + odd, inner + inner_odd), middle) + aside);
}

inline void join_four(const Strip* const (&first_from)[lanes], const Strip* const (&last_from)[lanes], Strip* joined,
                      std::size_t together) {
  const Lanes half = splat(0.5), zero = splat(0), one = splat(1);
  Strips first, last;
  load_strips(first_from, first);
  load_strips(last_from, last);
  // In the middle of both, where the slope of a parabola is the mean of theirs in the same proportion.
  const Lanes both = first.length + last.length, share = last.length / both;
  const Lanes x = first.x + share * (last.x - first.x), y = first.y + share * (last.y - first.y);
  const Lanes sense = first.ax * last.ax + first.ay * last.ay < zero ? -one : one;
  Lanes ax = first.length * first.ax + sense * last.length * last.ax;
  Lanes ay = first.length * first.ay + sense * last.length * last.ay;
  const Lanes square = ax * ax + ay * ay;
  const LaneMask sound = (square > splat(0x1p-960)) & (square < splat(0x1p1000));
  const Lanes part = one / square_root(sound ? square : one);
  ax = sound ? ax * part : one;
  ay = sound ? ay * part : zero;

  Part of_first, of_last;
  place_part(first, x, y, ax, ay, of_first);
  place_part(last, x, y, ax, ay, of_last);
  const Lanes far = max(of_first.far, of_last.far);
  const Lanes between = of_last.u - of_first.u;
  const Lanes mean = half * (first.bend + sense * last.bend);
  const Lanes turn = sense * (of_last.sine * of_first.cosine - of_first.sine * of_last.cosine);
  const Lanes slopes = half * turn / (sense * of_first.cosine * of_last.cosine * between);
  Lanes bend = absolute(between) > half * both ? slopes : mean;
  bend = absolute(bend) * far <= splat(0.9) ? bend : zero;

  // Where the two do not continue each other, a straight strip may be narrower.
  Lanes low = splat(__builtin_inf()), high = -low, straight_low = low, straight_high = high;
  add_part(first, of_first, bend, low, high);
  add_part(last, of_last, bend, low, high);
  add_part(first, of_first, zero, straight_low, straight_high);
  add_part(last, of_last, zero, straight_low, straight_high);
  const LaneMask straight = straight_high - straight_low < high - low;
  low = straight ? straight_low : low;
  high = straight ? straight_high : high;
  bend = straight ? zero : bend;
  // A value that is not a number anywhere is not one here.
  const Lanes doubt = (first.reach + last.reach + low) * zero;
  const Lanes shift = half * (low + high) + doubt, width = half * (high - low), rise = absolute(bend) * far * far;
  const Lanes middle_x = x - shift * ay, middle_y = y + shift * ax;
  const Lanes slack =
      splat(0x1p-45) * (absolute(middle_x) + absolute(middle_y) + far + rise + width) + splat(0x1p-1000);
  Lanes place[lanes] = {middle_x, middle_y, ax, ay};
  Lanes size[lanes] = {far + slack, width + slack, bend, rise + width + splat(4) * slack};
  transpose(place);
  transpose(size);
  for (std::size_t k = 0; k < together; ++k) {
    store(&joined[k].middle.x, place[k]);
    store(&joined[k].length, size[k]);
  }
}

inline void join_all(const Strip* below, std::size_t count, Strip* above) {
  for (std::size_t begin = 0; begin < count; begin += lanes) {
    const std::size_t together = count - begin < lanes ? count - begin : lanes;
    const Strip *first[lanes], *last[lanes];
    for (std::size_t k = 0; k < lanes; ++k) {
      const std::size_t pair = begin + (k < together ? k : 0);
      first[k] = &below[2 * pair];
      last[k] = &below[2 * pair + 1];
    }
    join_four(first, last, above + begin, together);
  }
}

}  // namespace
}  // namespace lober::detail
