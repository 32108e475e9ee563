// The shoelace sum segment by segment.
#pragma once

#include <cstddef>

#include "kernels/double_double.hpp"
#include "kernels/leaf.hpp"
#include "kernels/point.hpp"

namespace lober {

/// cross(a - origin, b - origin), twice the signed area of the triangle, error below 2^-102 times |a - origin| |b -
/// origin|.
LOBER_INLINE DD shoelace(Point a, Point b, Point origin) {
  return cross(two_diff(a.x, origin.x), two_diff(a.y, origin.y), two_diff(b.x, origin.x), two_diff(b.y, origin.y));
}

/// The same value for the leaf_size segments of a leaf, four at a time, from a - origin and the edge b - a: error below
/// 2^-102 times |a - origin| |b - a|. The last bits may differ from those of `shoelace`.
void shoelace_terms(const Point* points, Point origin, DD* terms);

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

}  // namespace lober
