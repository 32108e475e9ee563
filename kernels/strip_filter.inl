// Body of keep_near (kernels/all.inl).
#pragma once

#include "kernels/simd.hpp"
#include "kernels/strip_lanes.inl"
#include "kernels/strip_value.hpp"

namespace lober::detail {
namespace {

// A strip in the coordinates of another: where its middle is, and the cosine and sine by which it is turned.
struct Relative {
  Lanes u, v, cosine, sine, secant;
  Lanes length, width, bend, reach;
};

// Whether the strip `other` certainly has no point in common with the one of this bend, length and width: that would be
// where |u| <= length, and on that part of `other` the polynomial tells how far it is beside the parabola.
inline LaneMask lies_beside(Lanes bend, Lanes length, Lanes width, const Relative& other) {
  const Lanes zero = splat(0), two = splat(2), three = splat(3), four = splat(4);
  const Lanes c = other.cosine, s = other.sine;
  StripValue<Lanes> g;
  strip_value(bend, other.u, other.v, c, s, other.bend, g);
  const Lanes out = absolute(s) * other.reach, far = absolute(other.u) + absolute(c) * other.length + out;
  const Lanes steep = absolute(bend) * far;
  // The part with |u| <= length, a little more of it for rounding.
  const Lanes within = length + out + splat(0x1p-40) * far;
  const Lanes from = (-within - other.u) * other.secant, to = (within - other.u) * other.secant;
  const LaneMask along = absolute(c) > splat(0.25);
  const Lanes low = max(-other.length, along ? min(from, to) : -other.length);
  const Lanes high = min(other.length, along ? max(from, to) : other.length);
  const Lanes p = splat(0.5) * (low + high), half = splat(0.5) * (high - low);
  const Lanes value = g.c0 + p * (g.c1 + p * (g.c2 + p * (g.c3 + p * g.c4)));
  const Lanes slope = g.c1 + p * (two * g.c2 + p * (three * g.c3 + p * four * g.c4));
  const Lanes curve = g.c2 + p * (three * g.c3 + p * splat(6) * g.c4), third = g.c3 + four * p * g.c4;
  const Lanes square = half * half;
  const Lanes aside = absolute(slope) * half + square * (absolute(third) * half + absolute(g.c4) * square) +
                      absolute(c) * other.width + absolute(bend * s) * other.width * two * far +
                      splat(0x1p-40) * steep * far + width;
  const Lanes above = value + min(zero, curve) * square, below = value + max(zero, curve) * square;
  return (((above > aside) | (-below > aside)) & (steep <= four)) | (half < zero);
}

inline unsigned certainly_apart(const Strips& a, const Strips& b) {
  const Lanes dx = b.x - a.x, dy = b.y - a.y;
  const Lanes cosine = a.ax * b.ax + a.ay * b.ay, sine = a.ax * b.ay - a.ay * b.ax, secant = splat(1) / cosine;
  const Relative of_b{
      a.ax * dx + a.ay * dy, a.ax * dy - a.ay * dx, cosine, sine, secant, b.length, b.width, b.bend, b.reach};
  const unsigned beside_a = mask_bits(lies_beside(a.bend, a.length, a.width, of_b));
  if (beside_a == 15) return beside_a;
  const Relative of_a{
      -(b.ax * dx + b.ay * dy), b.ay * dx - b.ax * dy, cosine, -sine, secant, a.length, a.width, a.bend, a.reach};
  return beside_a | mask_bits(lies_beside(b.bend, b.length, b.width, of_a));
}

inline std::size_t keep_strips(const Strip* first, const Strip* second, NodePair* pairs, std::size_t count) {
  std::size_t kept = 0;
  for (std::size_t begin = 0; begin < count; begin += lanes) {
    const std::size_t together = count - begin < lanes ? count - begin : lanes;
    NodePair four[lanes];
    const Strip *from_first[lanes], *from_second[lanes];
    for (std::size_t k = 0; k < lanes; ++k) {
      four[k] = pairs[begin + (k < together ? k : 0)];
      from_first[k] = &first[four[k].first];
      from_second[k] = &second[four[k].second];
    }
    Strips a, b;
    load_strips(from_first, a);
    load_strips(from_second, b);
    const unsigned apart = certainly_apart(a, b);
    for (std::size_t k = 0; k < together; ++k) {
      pairs[kept] = four[k];
      kept += ~apart >> k & 1U;
    }
  }
  return kept;
}

}  // namespace
}  // namespace lober::detail
