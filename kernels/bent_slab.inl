// Bodies of bent_slab and segments_meeting (kernels/all.inl).
#pragma once

#include "kernels/bent_slab.hpp"
#include "kernels/simd.hpp"

namespace lober::detail {
namespace {

// u and v of the points of a leaf, the last one repeated, and what rounding can do to u, v and v - bend u^2.
struct PlacesAlong {
  static constexpr std::size_t size = leaf_size + lanes;
  alignas(32) double u[size];
  alignas(32) double v[size];
  double step;  // the greatest difference of u along a segment
  double far;   // bounds of |u| and |v|
  [[nodiscard]] double uncertainty(double bend) const {
    // u and v have four roundings of numbers below `far`, the height ten more; sums and products may underflow. For u
    // it is more than enough.
    return 0x1p-46 * (far + __builtin_fabs(bend) * far * far) + 0x1p-1000;
  }
};
inline void place_along(const Point* points, Point middle, Point along, PlacesAlong& places) {
  const double* const coordinates = &points[0].x;
  const Lanes x0 = splat(middle.x), y0 = splat(middle.y), ax = splat(along.x), ay = splat(along.y);
  Lanes size = splat(0), longest = size, before = size;
  const auto put = [&](std::size_t i, Lanes x, Lanes y) {
    x -= x0;
    y -= y0;
    const Lanes u = ax * x + ay * y;
    store(places.u + i, u);
    store(places.v + i, ax * y - ay * x);
    size = max(size, absolute(x) + absolute(y));
    if (i == 0) before = splat(u[0]);
    longest = max(longest, absolute(u - __builtin_shufflevector(before, u, 3, 4, 5, 6)));
    before = u;
  };
  for (std::size_t i = 0; i < leaf_size; i += lanes) {
    const Lanes first = load(coordinates + 2 * i), second = load(coordinates + 2 * i + 4);
    put(i, __builtin_shufflevector(first, second, 0, 2, 4, 6), __builtin_shufflevector(first, second, 1, 3, 5, 7));
  }
  put(leaf_size, splat(points[leaf_size].x), splat(points[leaf_size].y));
  places.step = greatest(longest);
  places.far = (__builtin_fabs(along.x) + __builtin_fabs(along.y)) * greatest(size);
}

// The height of a point, v - bend u^2, in four lanes.
inline Lanes heights_at(const PlacesAlong& places, double bend, std::size_t i) {
  const Lanes u = load(places.u + i);
  return load(places.v + i) - splat(bend) * u * u;
}
// By how much a segment may reach beyond the heights of its ends: above where that is positive, else below.
inline double sagitta_of(const PlacesAlong& places, double bend) {
  return bend == 0 ? 0 : 0.25 * bend * places.step * places.step;
}

inline void bound_bent_slab(const PlacesAlong& places, BentSlab& slab) {
  Lanes low = heights_at(places, slab.bend, leaf_size), high = low;
  Lanes left = load(places.u + leaf_size), right = left;
  for (std::size_t i = 0; i < leaf_size; i += lanes) {
    const Lanes height = heights_at(places, slab.bend, i), u = load(places.u + i);
    low = min(low, height);
    high = max(high, height);
    left = min(left, u);
    right = max(right, u);
  }
  const double uncertainty = places.uncertainty(slab.bend), sagitta = sagitta_of(places, slab.bend);
  slab.low = least(low) - uncertainty + (sagitta < 0 ? sagitta : 0);
  slab.high = greatest(high) + uncertainty + (sagitta > 0 ? sagitta : 0);
  slab.left = least(left) - uncertainty;
  slab.right = greatest(right) + uncertainty;
}

// Along the parabola through both ends and the middle, or the chord, whichever is narrower.
inline void fit_bent_slab(const Point* points, BentSlab& slab) {
  const Point from = points[0], to = points[leaf_size];
  slab = {{0.5 * from.x + 0.5 * to.x, 0.5 * from.y + 0.5 * to.y}, {to.x - from.x, to.y - from.y}, 0, 0, 0, 0, 0};
  if (!__builtin_isfinite(slab.along.x) || !__builtin_isfinite(slab.along.y)) slab.along = {0, 0};
  PlacesAlong places;
  place_along(points, slab.middle, slab.along, places);
  bound_bent_slab(places, slab);
  const double end = places.u[leaf_size], u = places.u[leaf_size / 2], v = places.v[leaf_size / 2];
  BentSlab bent = slab;
  bent.bend = v / (u * u - end * end);
  if (!(__builtin_fabs(u) < 0.75 * end) || !__builtin_isfinite(bent.bend)) return;
  bound_bent_slab(places, bent);
  if (bent.high - bent.low < slab.high - slab.low) slab = bent;
}

inline std::uint32_t meeting_bent_slab(const BentSlab& slab, const Point* b) {
  PlacesAlong places;
  place_along(b, slab.middle, slab.along, places);
  const double uncertainty = places.uncertainty(slab.bend), sagitta = sagitta_of(places, slab.bend);
  const Lanes low = splat(slab.low - uncertainty - (sagitta > 0 ? sagitta : 0)),
              high = splat(slab.high + uncertainty - (sagitta < 0 ? sagitta : 0));
  std::uint64_t above = 0, below = 0;  // bits of the points
  for (std::size_t i = 0; i < leaf_size + lanes; i += lanes) {
    const Lanes height = heights_at(places, slab.bend, i);
    above |= static_cast<std::uint64_t>(mask_bits(height > high)) << i;
    below |= static_cast<std::uint64_t>(mask_bits(height < low)) << i;
  }
  const std::uint64_t beside = (above & above >> 1) | (below & below >> 1);
  if (static_cast<std::uint32_t>(~beside) == 0) return 0;
  const Lanes left = splat(slab.left - uncertainty), right = splat(slab.right + uncertainty);
  std::uint64_t before = 0, behind = 0;
  for (std::size_t i = 0; i < leaf_size + lanes; i += lanes) {
    const Lanes u = load(places.u + i);
    before |= static_cast<std::uint64_t>(mask_bits(u < left)) << i;
    behind |= static_cast<std::uint64_t>(mask_bits(u > right)) << i;
  }
  return ~static_cast<std::uint32_t>(beside | (before & before >> 1) | (behind & behind >> 1));
}

}  // namespace
}  // namespace lober::detail
