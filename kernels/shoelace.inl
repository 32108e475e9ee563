// Bodies of shoelace_prefixes and sums_at (kernels/all.inl).
#pragma once

#include "kernels/shoelace.hpp"
#include "kernels/simd.hpp"

namespace lober::detail {
namespace {

// cross(a - o, b - o) = cross(a - o, b - a), where b - a is short and, mostly, exact in double.
inline BasicDD<Lanes> terms_of(Lanes ax, Lanes ay, Lanes bx, Lanes by, Lanes x, Lanes y) {
  const BasicDD<Lanes> rx = two_diff(ax, x), ry = two_diff(ay, y), ex = two_diff(bx, ax), ey = two_diff(by, ay);
  if (mask_bits((ex.lo == 0) & (ey.lo == 0)) != 15U) return cross(rx, ry, ex, ey);
  const BasicDD<Lanes> left = two_product(rx.hi, ey.hi), right = two_product(ry.hi, ex.hi);
  const BasicDD<Lanes> main = two_diff(left.hi, right.hi);
  return fast_two_sum(main.hi, main.lo + ((left.lo - right.lo) + (rx.lo * ey.hi - ry.lo * ex.hi)));
}

// Calls take(i, term) for each step i of a leaf, in order: lane l goes along the l-th quarter of the leaf, so that four
// sums run side by side.
#ifdef __AVX512F__
using EightLanes = double __attribute__((vector_size(64)));

LOBER_INLINE EightLanes joined(Lanes a, Lanes b) {
  return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7);
}
LOBER_INLINE BasicDD<EightLanes> two_product_of_eight(EightLanes a, EightLanes b) {
  const EightLanes product = a * b;
  return {product, _mm512_fmsub_pd(a, b, product)};
}

// Two steps at once, where all differences are exact in double.
template <typename Take>
LOBER_INLINE void for_each_step(const Point* points, Point origin, const Take& take) {
  const double* coordinates = &points[0].x;
  const Lanes x = splat(origin.x), y = splat(origin.y);
  const EightLanes x8 = joined(x, x), y8 = joined(y, y);
  // The points of step i and of the next one.
  const auto load_step = [&](std::size_t i, Lanes (&row)[lanes]) {
    for (std::size_t l = 0; l < lanes; ++l) row[l] = load(coordinates + 2 * (l * LeafPrefixes::quarter + i));
    transpose(row);
  };
  Lanes row[lanes];
  load_step(0, row);
  for (std::size_t i = 0; i < LeafPrefixes::quarter; i += 2) {
    Lanes next[lanes];
    const bool last = i + 2 == LeafPrefixes::quarter;
    load_step(last ? i + 1 : i + 2, next);
    const Lanes end_x = last ? next[2] : next[0], end_y = last ? next[3] : next[1];
    const EightLanes ax = joined(row[0], row[2]), ay = joined(row[1], row[3]);
    const BasicDD<EightLanes> ex = two_diff(joined(row[2], end_x), ax), ey = two_diff(joined(row[3], end_y), ay);
    if (_mm512_cmp_pd_mask(ex.lo, EightLanes{}, _CMP_EQ_OQ) == 255 &&
        _mm512_cmp_pd_mask(ey.lo, EightLanes{}, _CMP_EQ_OQ) == 255) {
      const BasicDD<EightLanes> rx = two_diff(ax, x8), ry = two_diff(ay, y8);
      const BasicDD<EightLanes> left = two_product_of_eight(rx.hi, ey.hi), right = two_product_of_eight(ry.hi, ex.hi);
      const BasicDD<EightLanes> main = two_diff(left.hi, right.hi);
      const BasicDD<EightLanes> term =
          fast_two_sum(main.hi, main.lo + ((left.lo - right.lo) + (rx.lo * ey.hi - ry.lo * ex.hi)));
      take(i, BasicDD<Lanes>{__builtin_shufflevector(term.hi, term.hi, 0, 1, 2, 3),
                             __builtin_shufflevector(term.lo, term.lo, 0, 1, 2, 3)});
      take(i + 1, BasicDD<Lanes>{__builtin_shufflevector(term.hi, term.hi, 4, 5, 6, 7),
                                 __builtin_shufflevector(term.lo, term.lo, 4, 5, 6, 7)});
    } else {
      take(i, terms_of(row[0], row[1], row[2], row[3], x, y));
      take(i + 1, terms_of(row[2], row[3], end_x, end_y, x, y));
    }
    for (std::size_t l = 0; l < lanes; ++l) row[l] = next[l];
  }
}
#else
template <typename Take>
LOBER_INLINE void for_each_step(const Point* points, Point origin, const Take& take) {
  const double* coordinates = &points[0].x;
  const Lanes x = splat(origin.x), y = splat(origin.y);
  for (std::size_t i = 0; i < LeafPrefixes::quarter; ++i) {
    Lanes row[lanes];
    for (std::size_t l = 0; l < lanes; ++l) row[l] = load(coordinates + 2 * (l * LeafPrefixes::quarter + i));
    transpose(row);
    take(i, terms_of(row[0], row[1], row[2], row[3], x, y));
  }
}
#endif

// In the end each of the four sums is raised by what comes before its quarter.
inline DD prefixes_of(const Point* points, Point origin, DD start, const DD* extra, LeafPrefixes& result) {
  Lanes high = splat(0), low = splat(0);
  for_each_step(points, origin, [&](std::size_t i, BasicDD<Lanes> term) {
    const std::size_t at = i * lanes;
    store(result.term_high + at, term.hi);
    store(result.term_low + at, term.lo);
    store(result.before_high + at, high);
    store(result.before_low + at, low);
    BasicDD<Lanes> sum = two_sum(high, term.hi);
    low += sum.lo + term.lo;
    if (extra != nullptr) {
      Lanes more_high, more_low;
      for (std::size_t l = 0; l < lanes; ++l) {
        more_high[l] = extra[l * LeafPrefixes::quarter + i].hi;
        more_low[l] = extra[l * LeafPrefixes::quarter + i].lo;
      }
      sum = two_sum(sum.hi, more_high);
      low += sum.lo + more_low;
    }
    high = sum.hi;
  });
  Lanes start_high, start_low;
  for (std::size_t l = 0; l < lanes; ++l) {
    start_high[l] = start.hi;
    start_low[l] = start.lo;
    const DD sum = two_sum(start.hi, high[l]);
    start = fast_two_sum(sum.hi, sum.lo + (start.lo + low[l]));
  }
  for (std::size_t at = 0; at < leaf_size; at += lanes) {
    const BasicDD<Lanes> sum = two_sum(start_high, load(result.before_high + at));
    store(result.before_high + at, sum.hi);
    store(result.before_low + at, sum.lo + (start_low + load(result.before_low + at)));
  }
  return start;
}

// The same without what comes before each segment.
inline DD sum_of_leaf(const Point* points, Point origin) {
  Lanes high = splat(0), low = splat(0);
  for_each_step(points, origin, [&](std::size_t /*i*/, BasicDD<Lanes> term) {
    const BasicDD<Lanes> sum = two_sum(high, term.hi);
    high = sum.hi;
    low += sum.lo + term.lo;
  });
  DD total;
  for (std::size_t l = 0; l < lanes; ++l) {
    const DD sum = two_sum(total.hi, high[l]);
    total = fast_two_sum(sum.hi, sum.lo + (total.lo + low[l]));
  }
  return total;
}

// Loads four double-doubles, lanes in the order 0, 2, 1, 3, and stores them so.
inline BasicDD<Lanes> load_four(const DD* from) {
  const Lanes first = load(&from[0].hi), second = load(&from[2].hi);
  return {__builtin_shufflevector(first, second, 0, 4, 2, 6), __builtin_shufflevector(first, second, 1, 5, 3, 7)};
}
inline void store_four(DD* to, BasicDD<Lanes> value) {
  store(&to[0].hi, __builtin_shufflevector(value.hi, value.lo, 0, 4, 2, 6));
  store(&to[2].hi, __builtin_shufflevector(value.hi, value.lo, 1, 5, 3, 7));
}

inline void four_sums_at(const LeafPrefixes& prefixes, const std::uint32_t* segments, const DD* t, DD* sums) {
  const auto index = [&](std::size_t k) { return LeafPrefixes::index_of(segments[k] % leaf_size); };
  const std::size_t a = index(0), b = index(2), c = index(1), d = index(3);
  const auto gather = [&](const double* from) { return Lanes{from[a], from[b], from[c], from[d]}; };
  const BasicDD<Lanes> term{gather(prefixes.term_high), gather(prefixes.term_low)};
  const BasicDD<Lanes> part = load_four(t) * term;
  const BasicDD<Lanes> sum = two_sum(gather(prefixes.before_high), part.hi);
  store_four(sums, fast_two_sum(sum.hi, sum.lo + (gather(prefixes.before_low) + part.lo)));
}

inline void all_sums_at(const LeafPrefixes& prefixes, const std::uint32_t* segments, const DD* t, std::size_t count,
                        DD* sums) {
  std::size_t k = 0;
  for (; k + lanes <= count; k += lanes) four_sums_at(prefixes, segments + k, t + k, sums + k);
  if (k == count) return;
  std::uint32_t rest_segments[lanes];
  DD rest_t[lanes]{}, rest_sums[lanes]{};
  for (std::size_t l = 0; l < lanes; ++l) {
    const std::size_t from = k + l < count ? k + l : count - 1;
    rest_segments[l] = segments[from];
    rest_t[l] = t[from];
  }
  four_sums_at(prefixes, rest_segments, rest_t, rest_sums);
  for (std::size_t l = 0; k + l < count; ++l) sums[k + l] = rest_sums[l];
}

}  // namespace
}  // namespace lober::detail
