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

// Lane l takes the l-th quarter of the leaf, so that four sums run side by side; in the end each is raised by what
// comes before its quarter.
inline DD prefixes_of(const Point* points, Point origin, DD start, const DD* extra, LeafPrefixes& result) {
  const double* coordinates = &points[0].x;
  const Lanes x = splat(origin.x), y = splat(origin.y);
  Lanes high = splat(0), low = splat(0);
  for (std::size_t i = 0; i < LeafPrefixes::quarter; ++i) {
    Lanes row[lanes];
    for (std::size_t l = 0; l < lanes; ++l) row[l] = load(coordinates + 2 * (l * LeafPrefixes::quarter + i));
    transpose(row);
    const BasicDD<Lanes> term = terms_of(row[0], row[1], row[2], row[3], x, y);
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
  }
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
  const double* coordinates = &points[0].x;
  const Lanes x = splat(origin.x), y = splat(origin.y);
  Lanes high = splat(0), low = splat(0);
  for (std::size_t i = 0; i < LeafPrefixes::quarter; ++i) {
    Lanes row[lanes];
    for (std::size_t l = 0; l < lanes; ++l) row[l] = load(coordinates + 2 * (l * LeafPrefixes::quarter + i));
    transpose(row);
    const BasicDD<Lanes> term = terms_of(row[0], row[1], row[2], row[3], x, y), sum = two_sum(high, term.hi);
    high = sum.hi;
    low += sum.lo + term.lo;
  }
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
