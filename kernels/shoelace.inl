// Bodies of shoelace_prefixes and sums_at (kernels/all.inl).
#pragma once

#include "kernels/eight.hpp"
#include "kernels/fours.inl"
#include "kernels/shoelace.hpp"

namespace lober::detail {
namespace {

// cross(a - o, b - o) = cross(a - o, b - a), where b - a is short and, mostly, exact in double. Whether it is, four
// columns decide together.
inline BasicDD<Widest> terms_of(Widest ax, Widest ay, Widest bx, Widest by, Widest x, Widest y) {
  const BasicDD<Widest> rx = two_diff(ax, x), ry = two_diff(ay, y), ex = two_diff(bx, ax), ey = two_diff(by, ay);
  const BasicDD<Widest> left = two_product(rx.hi, ey.hi), right = two_product(ry.hi, ex.hi);
  const BasicDD<Widest> main = two_diff(left.hi, right.hi);
  const BasicDD<Widest> of_exact =
      fast_two_sum(main.hi, main.lo + ((left.lo - right.lo) + (rx.lo * ey.hi - ry.lo * ex.hi)));
  const Widest zero = splat_widest(0);
  const unsigned exact = mask_bits(both(equal(ex.lo, zero), equal(ey.lo, zero)));
  if (exact == (1U << widest) - 1) return of_exact;
  const BasicDD<Widest> of_any = cross(rx, ry, ex, ey);
#ifdef __AVX512F__
  const auto fours = static_cast<EightMask>(((exact & 15U) == 15U ? 15U : 0U) | (exact >= 240U ? 240U : 0U));
  return {choose(fours, of_exact.hi, of_any.hi), choose(fours, of_exact.lo, of_any.lo)};
#else
  return of_any;
#endif
}

constexpr std::size_t column = LeafPrefixes::column;
static_assert(column == 4);

// A running sum of each column, as RunningSum.
template <typename Numbers>
struct ColumnSums {
  Numbers high, low;
  LOBER_INLINE void add(BasicDD<Numbers> term) {
    const BasicDD<Numbers> sum = two_sum(high, term.hi);
    high = sum.hi;
    low = low + (sum.lo + term.lo);
  }
};
// Adds to each column the sums of all before it: those of one, of two and of four at once.
inline void join_columns(ColumnSums<Eight>& sums) {
  sums.add({moved_up<1>(sums.high), moved_up<1>(sums.low)});
  sums.add({moved_up<2>(sums.high), moved_up<2>(sums.low)});
  sums.add({moved_up<4>(sums.high), moved_up<4>(sums.low)});
}

// Calls take(part, i, term) for each part of the columns and each step i of theirs, in order, and end(part) behind the
// last one.
template <typename Take, typename End>
LOBER_INLINE void for_each_step(const Point* points, Point origin, const Take& take, const End& end) {
  const Widest x = splat_widest(origin.x), y = splat_widest(origin.y);
  for (std::size_t k = 0; k < parts_of_eight; ++k) {
    const Point* const from = points + k * widest * column;
    Widest px[column], py[column];
    load_fours(&from[0].x, px, py);
    const Point next = from[widest * column];
    const Widest end_x = followed_by(px[0], next.x), end_y = followed_by(py[0], next.y);
    for (std::size_t i = 0; i < column; ++i) {
      const bool last = i + 1 == column;
      take(k, i, terms_of(px[i], py[i], last ? end_x : px[i + 1], last ? end_y : py[i + 1], x, y));
    }
    end(k);
  }
}

// In the end the sums of each column are raised by what comes before it.
inline DD prefixes_of(const Point* points, Point origin, DD start, const DD* extra, LeafPrefixes& result) {
  const Widest nothing = splat_widest(0);
  ColumnSums<Widest> sums{nothing, nothing};
  Widest high[parts_of_eight], low[parts_of_eight], extra_high[column], extra_low[column];
  for_each_step(
      points, origin,
      [&](std::size_t k, std::size_t i, BasicDD<Widest> term) {
        const std::size_t at = i * eight + k * widest;
        store(result.term_high + at, term.hi);
        store(result.term_low + at, term.lo);
        store(result.before_high + at, sums.high);
        store(result.before_low + at, sums.low);
        sums.add(term);
        if (extra == nullptr) return;
        if (i == 0) load_fours(&extra[k * widest * column].hi, extra_high, extra_low);
        sums.add({extra_high[i], extra_low[i]});
      },
      [&](std::size_t k) {
        high[k] = sums.high;
        low[k] = sums.low;
        sums = {nothing, nothing};
      });
  ColumnSums<Eight> all{eight_of(high), eight_of(low)};
  join_columns(all);
  const BasicDD<Eight> from = two_sum(splat_eight(start.hi), moved_up<1>(all.high));
  const Eight from_low = from.lo + (splat_eight(start.lo) + moved_up<1>(all.low));
  for (std::size_t at = 0; at < leaf_size; at += widest) {
    const std::size_t k = at % eight / widest;
    const BasicDD<Widest> sum = two_sum(part_of(from.hi, k), load_widest(result.before_high + at));
    store(result.before_high + at, sum.hi);
    store(result.before_low + at, sum.lo + (part_of(from_low, k) + load_widest(result.before_low + at)));
  }
  const DD end = two_sum(start.hi, last_of(all.high));
  return fast_two_sum(end.hi, end.lo + (start.lo + last_of(all.low)));
}

// The same without what comes before each segment.
inline DD sum_of_leaf(const Point* points, Point origin) {
  const Widest nothing = splat_widest(0);
  ColumnSums<Widest> sums{nothing, nothing};
  Widest high[parts_of_eight], low[parts_of_eight];
  for_each_step(
      points, origin, [&](std::size_t /*k*/, std::size_t /*i*/, BasicDD<Widest> term) { sums.add(term); },
      [&](std::size_t k) {
        high[k] = sums.high;
        low[k] = sums.low;
        sums = {nothing, nothing};
      });
  ColumnSums<Eight> all{eight_of(high), eight_of(low)};
  join_columns(all);
  return fast_two_sum(last_of(all.high), last_of(all.low));
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
