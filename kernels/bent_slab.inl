// Bodies of bent_slab and segments_meeting (kernels/all.inl).
#pragma once

#include "kernels/bent_slab.hpp"
#include "kernels/eight.hpp"

namespace lober::detail {
namespace {

// u and v of the points of a leaf, the last one repeated, and what rounding can do to u, v and v - bend u^2.
struct PlacesAlong {
  static constexpr std::size_t size = leaf_size + widest;
  alignas(64) double u[size];
  alignas(64) double v[size];
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
  const Widest x0 = splat_widest(middle.x), y0 = splat_widest(middle.y), ax = splat_widest(along.x),
               ay = splat_widest(along.y);
  Widest size = splat_widest(0), longest = size, before = size;
  const auto put = [&](std::size_t i, Widest x, Widest y) {
    x -= x0;
    y -= y0;
    const Widest u = ax * x + ay * y;
    store(places.u + i, u);
    store(places.v + i, ax * y - ay * x);
    size = max(size, absolute(x) + absolute(y));
    if (i == 0) before = splat_widest(u[0]);
    longest = max(longest, absolute(u - preceded_by(u, before)));
    before = u;
  };
  for (std::size_t i = 0; i < leaf_size; i += widest) {
    const Widest first = load_widest(coordinates + 2 * i), second = load_widest(coordinates + 2 * i + widest);
    put(i, evens(first, second), odds(first, second));
  }
  put(leaf_size, splat_widest(points[leaf_size].x), splat_widest(points[leaf_size].y));
  places.step = greatest(greatest_four(longest));
  places.far = (__builtin_fabs(along.x) + __builtin_fabs(along.y)) * greatest(greatest_four(size));
}

// The heights of some points, v - bend u^2.
inline Widest heights_at(const PlacesAlong& places, double bend, std::size_t i) {
  const Widest u = load_widest(places.u + i);
  return load_widest(places.v + i) - splat_widest(bend) * u * u;
}
// By how much a segment may reach beyond the heights of its ends: above where that is positive, else below.
inline double sagitta_of(const PlacesAlong& places, double bend) {
  return bend == 0 ? 0 : 0.25 * bend * places.step * places.step;
}

inline void bound_bent_slab(const PlacesAlong& places, BentSlab& slab) {
  Widest low = heights_at(places, slab.bend, leaf_size), high = low;
  Widest left = load_widest(places.u + leaf_size), right = left;
  for (std::size_t i = 0; i < leaf_size; i += widest) {
    const Widest height = heights_at(places, slab.bend, i), u = load_widest(places.u + i);
    low = min(low, height);
    high = max(high, height);
    left = min(left, u);
    right = max(right, u);
  }
  const double uncertainty = places.uncertainty(slab.bend), sagitta = sagitta_of(places, slab.bend);
  slab.low = least(least_four(low)) - uncertainty + (sagitta < 0 ? sagitta : 0);
  slab.high = greatest(greatest_four(high)) + uncertainty + (sagitta > 0 ? sagitta : 0);
  slab.left = least(least_four(left)) - uncertainty;
  slab.right = greatest(greatest_four(right)) + uncertainty;
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
  const Widest low = splat_widest(slab.low - uncertainty - (sagitta > 0 ? sagitta : 0)),
               high = splat_widest(slab.high + uncertainty - (sagitta < 0 ? sagitta : 0));
  std::uint64_t above = 0, below = 0;  // bits of the points
  for (std::size_t i = 0; i < leaf_size + 1; i += widest) {
    const Widest height = heights_at(places, slab.bend, i);
    above |= static_cast<std::uint64_t>(mask_bits(less(high, height))) << i;
    below |= static_cast<std::uint64_t>(mask_bits(less(height, low))) << i;
  }
  const std::uint64_t beside = (above & above >> 1) | (below & below >> 1);
  if (static_cast<std::uint32_t>(~beside) == 0) return 0;
  const Widest left = splat_widest(slab.left - uncertainty), right = splat_widest(slab.right + uncertainty);
  std::uint64_t before = 0, behind = 0;
  for (std::size_t i = 0; i < leaf_size + 1; i += widest) {
    const Widest u = load_widest(places.u + i);
    before |= static_cast<std::uint64_t>(mask_bits(less(u, left))) << i;
    behind |= static_cast<std::uint64_t>(mask_bits(less(right, u))) << i;
  }
  return ~static_cast<std::uint32_t>(beside | (before & before >> 1) | (behind & behind >> 1));
}

}  // namespace
}  // namespace lober::detail
