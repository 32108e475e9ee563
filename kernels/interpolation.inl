// Points of a cubic piece, two at a time: (x, y, x, y). See kernels/all.inl for the copies.
#pragma once

#include "kernels/interpolation.hpp"
#include "kernels/simd.hpp"

namespace lober::detail {
namespace {

LOBER_INLINE void subdivide_with(const CubicPiece& piece, std::uint32_t parts, std::uint32_t first, std::uint32_t last,
                                 Point* out) {
  const auto twice = [](Point p) { return Lanes{p.x, p.y, p.x, p.y}; };
  const Lanes a = twice(piece.a), chord = twice(piece.chord), u = twice(piece.u), v = twice(piece.v), one = splat(1);
  const double step = 1.0 / parts;
  std::uint32_t k = first;
  Lanes number{1.0 * k, 1.0 * k, k + 1.0, k + 1.0};  // whole, so that number * step is k * step to the bit
  for (; k + 2 <= last; k += 2, out += 2, number += splat(2)) {
    const Lanes t = number * splat(step);
    store(&out->x, a + t * (chord + (one - t) * (u + t * v)));
  }
  if (k < last) *out = piece.at(k * step);
}

}  // namespace
}  // namespace lober::detail
