// The shoelace sum segment by segment.
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernels/double_double.hpp"
#include "kernels/eight.hpp"
#include "kernels/leaf.hpp"
#include "kernels/point.hpp"

namespace lober::detail {

/// cross(a - origin, b - origin), twice the signed area of the triangle, error below 2^-102 times |a - origin| |b -
/// origin|.
LOBER_INLINE DD shoelace(Point a, Point b, Point origin) {
  return cross(two_diff(a.x, origin.x), two_diff(a.y, origin.y), two_diff(b.x, origin.x), two_diff(b.y, origin.y));
}

/// The shoelace terms of the segments of a leaf and, for each, the sum of all that come before it.
struct alignas(64) LeafPrefixes {
  static constexpr std::size_t column = leaf_size / eight;
  double term_high[leaf_size], term_low[leaf_size];
  double before_high[leaf_size], before_low[leaf_size];

  /// Segments are stored in this order: eight sums run side by side.
  [[nodiscard]] LOBER_INLINE static constexpr std::size_t index_of(std::size_t segment) {
    return segment % column * eight + segment / column;
  }
  [[nodiscard]] LOBER_INLINE DD term(std::size_t segment) const {
    return {term_high[index_of(segment)], term_low[index_of(segment)]};
  }
  [[nodiscard]] LOBER_INLINE DD before(std::size_t segment) const {
    return {before_high[index_of(segment)], before_low[index_of(segment)]};
  }
};

/// Fills `prefixes` for the leaf_size segments of a leaf about `origin`, the first sum being `start`, and returns the
/// sum behind the last one. extra[k], unless extra is null, is added behind segment k. Error of a term below 2^-102
/// times |a - origin| |b - a|; of a sum, 40 times 2^-106 of the largest sum of up to leaf_size terms.
DD shoelace_prefixes(const Point* points, Point origin, DD start, const DD* extra, LeafPrefixes& prefixes);

/// The sum of the leaf_size segments of a leaf about `origin`, with the error of the last of shoelace_prefixes.
DD shoelace_of_leaf(const Point* points, Point origin);

/// The sums up to `count` positions on the leaf: sums[k] = before(s) + t[k] term(s), s = segments[k] % leaf_size. The
/// error of each keeps to the bound of a sum above.
void sums_at(const LeafPrefixes& prefixes, const std::uint32_t* segments, const DD* t, std::size_t count, DD* sums);

/// A running sum of double-doubles: the high parts exactly, the low parts rounded. Error after n additions at most
/// n 2^-106 times the largest partial sum; several times faster than adding double-doubles, because steps overlap.
class RunningSum {
 public:
  LOBER_INLINE void add(DD term) {
    const DD sum = two_sum(high_, term.hi);
    high_ = sum.hi;
    low_ += sum.lo + term.lo;
  }
  [[nodiscard]] LOBER_INLINE DD value() const { return two_sum(high_, low_); }

 private:
  double high_ = 0;
  double low_ = 0;
};

}  // namespace lober::detail
