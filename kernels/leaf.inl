// Body of summarise_leaves (kernels/all.inl).
#pragma once

#include "kernels/fetch.hpp"
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

// From this number of leaves on they are asked for ahead.
constexpr std::size_t long_run = 128;

// The points one before those of `here`; `last` is the vector before, `behind_last` what follows each of its points.
LOBER_INLINE Widest points_before([[maybe_unused]] Widest here, [[maybe_unused]] Widest last,
                                  [[maybe_unused]] Widest behind_last) {
#ifdef __AVX512F__
  return __builtin_shufflevector(last, here, 6, 7, 8, 9, 10, 11, 12, 13);
#else
  return behind_last;
#endif
}

// Box and flags of one leaf and, in four lanes, its shoelace sum taken as sum r_i.x (r_{i+1}.y - r_{i-1}.y) over all
// but the last point, r relative to the first: one exact product and one exact addition a point, if differences are
// exact. Everything in one loop over eight points at a time.
template <bool is_long>
inline void summarise_leaf(const Point* p, Box& box, std::uint8_t& flags, Lanes& sum_high, Lanes& sum_low) {
  const double* coordinates = &p[0].x;
  const Widest origin = splat_widest(p[0].x), nothing = splat_widest(0);
  Widest last = repeat(Lanes{p[0].x, p[0].y, p[0].x, p[0].y});  // any before the first: it is multiplied by r_0 = 0
  Widest low = last, high = last, behind_last = last, sum[parts_of_eight], rest[parts_of_eight];
  for (std::size_t k = 0; k < parts_of_eight; ++k) sum[k] = rest[k] = nothing;
  auto rises = equal(nothing, nothing), falls = rises;
#pragma GCC unroll 1
  for (std::size_t i = 0; i < leaf_size; i += eight) {
    if constexpr (is_long) {
      fetch(coordinates + 2 * i, bytes_ahead);
      fetch(coordinates + 2 * i, bytes_ahead + bytes_a_line);
    }
    for (std::size_t k = 0; k < parts_of_eight; ++k) {
      const double* const pair = coordinates + 2 * (i + k * widest);
      const Widest here0 = load_widest(pair), here1 = load_widest(pair + widest);
      const Widest after0 = load_widest(pair + 2), after1 = load_widest(pair + widest + 2);
      low = min(low, min(after0, after1));
      high = max(high, max(after0, after1));
      rises = both(rises, both(less(here0, after0), less(here1, after1)));
      falls = both(falls, both(less(after0, here0), less(after1, here1)));
      const Widest rise0 = after0 - points_before(here0, last, behind_last),
                   rise1 = after1 - points_before(here1, here0, after0);
      last = here1;
      behind_last = after1;
      const BasicDD<Widest> product = two_product(evens_crosswise(here0, here1) - origin, odds_crosswise(rise0, rise1));
      const BasicDD<Widest> next = two_sum(sum[k], product.hi);
      sum[k] = next.hi;
      rest[k] += next.lo + product.lo;
    }
  }
  const Eight all = eight_of(sum), rests = eight_of(rest);
  const BasicDD<Lanes> halves = two_sum(low_half(all), high_half(all));
  sum_high = halves.hi;
  sum_low = halves.lo + (low_half(rests) + high_half(rests));
  const Lanes lowest = least_four(low), highest = greatest_four(high);
  const Lanes least_corner = min(lowest, __builtin_shufflevector(lowest, lowest, 2, 3, 0, 1));
  const Lanes greatest_corner = max(highest, __builtin_shufflevector(highest, highest, 2, 3, 0, 1));
  store(box.lane, __builtin_shufflevector(least_corner, -greatest_corner, 0, 1, 6, 7));
  const auto of_all_points = [](unsigned bits) {
    if constexpr (widest == eight) bits &= bits >> 4U;
    return bits & bits >> 2U & 3U;
  };
  flags = static_cast<std::uint8_t>(of_all_points(mask_bits(rises)) | of_all_points(mask_bits(falls)) << 2U);
}

// Up to four leaves, so that the ends of their sums are joined side by side.
template <bool is_long>
inline void summarise_four(const Point* p, std::size_t count, Box* boxes, DD* sums, std::uint8_t* flags) {
  Lanes high[lanes] = {}, low[lanes] = {};
  Lanes width = splat(0), fall = splat(0);  // width of the chord, the last term r_n.x (r_0.y - r_{n-1}.y) of the sum
  for (std::size_t k = 0; k < count; ++k) {
    const Point* leaf = p + k * leaf_size;
    summarise_leaf<is_long>(leaf, boxes[k], flags[k], high[k], low[k]);
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

template <bool is_long>
inline void summarise_all(const Point* points, std::size_t first, std::size_t count, Box* boxes, DD* sums,
                          std::uint8_t* flags) {
  for (std::size_t leaf = first; leaf < first + count; leaf += lanes) {
    const std::size_t together = first + count - leaf < lanes ? first + count - leaf : lanes;
    summarise_four<is_long>(points + leaf * leaf_size, together, boxes + leaf, sums + leaf, flags + leaf);
  }
}

inline void summarise(const Point* points, std::size_t first, std::size_t count, Box* boxes, DD* sums,
                      std::uint8_t* flags) {
  if (count < long_run)
    summarise_all<false>(points, first, count, boxes, sums, flags);
  else
    summarise_all<true>(points, first, count, boxes, sums, flags);
}

}  // namespace
}  // namespace lober::detail
