// Body of flag_segments and lengths_in_box (kernels/all.inl).
#pragma once

#include "kernels/segment_flags.hpp"

namespace lober::detail {
namespace {

// Flags are as wide as numbers and nothing branches, so that compilers make vectors of each loop.
inline void flag_outside(const Point* points, std::size_t count, const Box& box, std::int64_t* outside) {
  const double min_x = box.min_x(), min_y = box.min_y(), max_x = box.max_x(), max_y = box.max_y();
  for (std::size_t k = 0; k < count; ++k) {
    const double x = points[k].x, y = points[k].y;
    const bool inside = (x >= min_x) & (x <= max_x) & (y >= min_y) & (y <= max_y);
    outside[k] = inside ? 0 : outside_segment;
  }
}

inline std::int64_t flag_all_segments(const SegmentRow& row, const SegmentBounds& bounds,
                                      std::int64_t* __restrict flags) {
  std::int64_t outside[max_flagged + 1], uneven[max_flagged + 1];
  double gaps[max_flagged + 2];  // as the lengths
  const double* const parameters = row.parameters;
  for (std::size_t k = 0; k < row.count; ++k) gaps[k + 1] = parameters[k + 1] - parameters[k];
  gaps[0] = row.has_before ? parameters[0] - parameters[-1] : 0;
  gaps[row.count + 1] = row.has_after ? parameters[row.count + 1] - parameters[row.count] : 0;
  flag_outside(row.points, row.count + 1, bounds.box, outside);
  const double *lengths = row.lengths, *bends = row.bends, *parts = row.parts;
  for (std::size_t k = 0; k <= row.count; ++k) {
    const double a = lengths[k] * gaps[k + 1], b = lengths[k + 1] * gaps[k];
    const double longer = lengths[k] > lengths[k + 1] ? lengths[k] : lengths[k + 1];
    const double larger = a > b ? a : b, smaller = a > b ? b : a;
    const bool differ = (bends[k] >= 0) & (longer >= bounds.visible) & (larger > bounds.unevenness * smaller);
    uneven[k] = differ ? uneven_segment : 0;
  }
  std::int64_t any = 0;
  for (std::size_t k = 0; k < row.count; ++k) {
    const double larger = bends[k] > bends[k + 1] ? bends[k] : bends[k + 1];
    const bool rough = (parts[k] > bounds.rough) | ((larger * lengths[k + 1] > bounds.sharp) & (parts[k] > 1));
    const std::int64_t is_unknown = larger < 0 ? unknown_segment : 0, is_rough = rough ? rough_segment : 0;
    const std::int64_t is_coarse = parts[k] > bounds.coarse ? coarse_segment : 0;
    flags[k] = is_unknown | is_rough | is_coarse | uneven[k] | uneven[k + 1] | outside[k] | outside[k + 1];
    any |= flags[k];
  }
  return any;
}

inline bool all_lengths_in_box(const Point* points, std::size_t count, const Box& box, double* __restrict lengths) {
  for (std::size_t k = 0; k < count; ++k) {
    const double x = points[k + 1].x - points[k].x, y = points[k + 1].y - points[k].y;
    lengths[k] = __builtin_sqrt(x * x + y * y);
  }
  std::int64_t outside[max_flagged + 1], any = 0;
  flag_outside(points, count + 1, box, outside);
  for (std::size_t k = 0; k <= count; ++k) any |= outside[k];
  return any == 0;
}

}  // namespace
}  // namespace lober::detail
