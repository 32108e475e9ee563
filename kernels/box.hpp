// Axis-parallel boxes, laid out so that one vector compare decides whether two of them meet.
#pragma once

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include <algorithm>
#include <limits>
#include <span>

#include "kernels/inline.hpp"
#include "kernels/point.hpp"

namespace lober::detail {

/// Closed box, stored as (min x, min y, -max x, -max y): uniting boxes is a minimum in all four lanes, and two boxes
/// a, b meet iff a.lane[k] <= -b.lane[k ^ 2] for every k. Negation is exact, so are all decisions.
struct alignas(32) Box {
  double lane[4] = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
                    std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  using LeftUnfilled = void;  ///< in arrays (lober/base/buffer.hpp)

  LOBER_INLINE static Box of(Point a, Point b) {
    return {{b.x < a.x ? b.x : a.x, b.y < a.y ? b.y : a.y, -(a.x < b.x ? b.x : a.x), -(a.y < b.y ? b.y : a.y)}};
  }
  [[nodiscard]] LOBER_INLINE double min_x() const { return lane[0]; }
  [[nodiscard]] LOBER_INLINE double min_y() const { return lane[1]; }
  [[nodiscard]] LOBER_INLINE double max_x() const { return -lane[2]; }
  [[nodiscard]] LOBER_INLINE double max_y() const { return -lane[3]; }
  [[nodiscard]] LOBER_INLINE double width() const { return max_x() - min_x(); }
  [[nodiscard]] LOBER_INLINE double height() const { return max_y() - min_y(); }
  operator Rectangle() const { return {min_x(), min_y(), max_x(), max_y()}; }  // NOLINT(google-explicit-constructor)
  /// Half the perimeter: the measure of size that never vanishes for a segment.
  [[nodiscard]] LOBER_INLINE double extent() const { return width() + height(); }
};

inline Box union_of(const Box& a, const Box& b) {
  return {{std::min(a.lane[0], b.lane[0]), std::min(a.lane[1], b.lane[1]), std::min(a.lane[2], b.lane[2]),
           std::min(a.lane[3], b.lane[3])}};
}

inline bool meet(const Box& a, const Box& b) {
  return a.lane[0] <= -b.lane[2] && a.lane[1] <= -b.lane[3] && a.lane[2] <= -b.lane[0] && a.lane[3] <= -b.lane[1];
}

/// Whether it holds one point alone: then so do the segments in it, and repeated vertices carry none.
LOBER_INLINE bool is_point(const Box& box) {
  return box.lane[0] == -box.lane[2] && box.lane[1] == -box.lane[3];
}

inline Box box_of(const Rectangle& rectangle) {
  return {{rectangle.min_x, rectangle.min_y, -rectangle.max_x, -rectangle.max_y}};
}

/// The box of all points; empty, meeting none, when there are none.
inline Box box_of(std::span<const Point> points) {
  Box box;
  for (const Point& point : points) box = union_of(box, Box::of(point, point));
  return box;
}

/// A box prepared for being tested against many: the right-hand sides of the four comparisons of `meet`.
struct alignas(32) BoxQuery {
  double bound[4];
  explicit BoxQuery(const Box& box) : bound{-box.lane[2], -box.lane[3], -box.lane[0], -box.lane[1]} {}
};

/// The same as for two boxes, without branches.
inline bool meet(const BoxQuery& query, const Box& box) {
#ifdef __SSE2__
  const __m128d low = _mm_cmple_pd(_mm_load_pd(box.lane), _mm_load_pd(query.bound));
  const __m128d high = _mm_cmple_pd(_mm_load_pd(box.lane + 2), _mm_load_pd(query.bound + 2));
  return _mm_movemask_pd(_mm_and_pd(low, high)) == 3;
#else
  return box.lane[0] <= query.bound[0] && box.lane[1] <= query.bound[1] && box.lane[2] <= query.bound[2] &&
         box.lane[3] <= query.bound[3];
#endif
}

}  // namespace lober::detail
