// Body of summarise_leaves (kernels/all.inl).
#pragma once

#include "kernels/leaf.hpp"
#include "kernels/shoelace.hpp"
#include "kernels/shoelace.inl"

namespace lober::detail {
namespace {

// All differences of two numbers in [low, high] are exact when they have one sign and high <= 2 low (Sterbenz 1974).
inline bool differences_exact(double low, double high) {
  return (low > 0 && high <= 2 * low) || (high < 0 && low >= 2 * high);
}

// Shoelace sum over the leaf about its first point, for any coordinates.
inline DD leaf_sum(const Point* p) {
  LeafPrefixes prefixes;
  return prefixes_of(p, p[0], {}, nullptr, prefixes);
}

// Box and flags of one leaf and, in four lanes, its shoelace sum taken as sum r_i.x (r_{i+1}.y - r_{i-1}.y) over all
// but the last point, r relative to the first: one exact product and one exact addition a point, if differences are
// exact. Everything in one loop over four points at a time.
inline void summarise_leaf(const Point* p, Box& box, std::uint8_t& flags, Lanes& sum_high, Lanes& sum_low) {
  const double* coordinates = &p[0].x;
  const Lanes origin = splat(p[0].x);
  Lanes before = {p[0].x, p[0].y, p[0].x, p[0].y};  // any: it is multiplied by r_0 = 0
  Lanes low = before, high = before;
  LaneMask rises = low == low, falls = rises;
  sum_high = sum_low = splat(0);
  for (std::size_t i = 0; i < leaf_size; i += lanes) {
    const Lanes here0 = load(coordinates + 2 * i), here1 = load(coordinates + 2 * i + 4);
    const Lanes after0 = load(coordinates + 2 * i + 2), after1 = load(coordinates + 2 * i + 6);
    low = min(low, min(after0, after1));
    high = max(high, max(after0, after1));
    rises &= (after0 > here0) & (after1 > here1);
    falls &= (after0 < here0) & (after1 < here1);
    const Lanes rise0 = after0 - before, rise1 = after1 - after0;
    before = after1;
    const Lanes x = __builtin_shufflevector(here0, here1, 0, 4, 2, 6) - origin;
    const Lanes rise = __builtin_shufflevector(rise0, rise1, 1, 5, 3, 7);
    const BasicDD<Lanes> product = two_product(x, rise);
    const BasicDD<Lanes> sum = two_sum(sum_high, product.hi);
    sum_high = sum.hi;
    sum_low += sum.lo + product.lo;
  }
  low = min(low, __builtin_shufflevector(low, low, 2, 3, 0, 1));
  high = max(high, __builtin_shufflevector(high, high, 2, 3, 0, 1));
  store(box.lane, __builtin_shufflevector(low, -high, 0, 1, 6, 7));
  const unsigned rise_bits = mask_bits(rises), fall_bits = mask_bits(falls);
  flags = static_cast<std::uint8_t>((rise_bits & (rise_bits >> 2)) | ((fall_bits & (fall_bits >> 2)) << 2));
}

// Up to four leaves, so that the ends of their sums are joined side by side.
inline void summarise_four(const Point* p, std::size_t count, Box* boxes, DD* sums, std::uint8_t* flags) {
  Lanes high[lanes] = {}, low[lanes] = {};
  Lanes width = splat(0), fall = splat(0);  // width of the chord, the last term r_n.x (r_0.y - r_{n-1}.y) of the sum
  for (std::size_t k = 0; k < count; ++k) {
    const Point* leaf = p + k * leaf_size;
    summarise_leaf(leaf, boxes[k], flags[k], high[k], low[k]);
    width[k] = leaf[leaf_size].x - leaf[0].x;
    fall[k] = leaf[0].y - leaf[leaf_size - 1].y;
  }
  transpose(high);
  transpose(low);
  const BasicDD<Lanes> chord = two_product(width, fall);
  const BasicDD<Lanes> even = two_sum(high[0], high[2]), odd = two_sum(high[1], high[3]);
  const BasicDD<Lanes> all = two_sum(even.hi, odd.hi), closed = two_sum(all.hi, chord.hi);
  const Lanes rest = ((low[0] + low[2]) + (low[1] + low[3])) + (((even.lo + odd.lo) + all.lo) + (closed.lo + chord.lo));
  const BasicDD<Lanes> sum = fast_two_sum(closed.hi, rest);
  for (std::size_t k = 0; k < count; ++k) {
    const Box& box = boxes[k];
    const bool exact = differences_exact(box.min_x(), box.max_x()) && differences_exact(box.min_y(), box.max_y());
    sums[k] = exact ? DD{sum.hi[k], sum.lo[k]} : leaf_sum(p + k * leaf_size);
  }
}

inline void summarise(const Point* points, std::size_t first, std::size_t count, Box* boxes, DD* sums,
                      std::uint8_t* flags) {
  for (std::size_t leaf = first; leaf < first + count; leaf += lanes) {
    const std::size_t together = first + count - leaf < lanes ? first + count - leaf : lanes;
    summarise_four(points + leaf * leaf_size, together, boxes + leaf, sums + leaf, flags + leaf);
  }
}

}  // namespace
}  // namespace lober::detail
