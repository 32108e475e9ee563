// Body of flag_segments, surely_fine and length_in_box (kernels/all.inl).
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

// Bounds are drawn in by much more than what rounding makes of products, and numbers are kept so near to one that
// none of the products overflows or underflows unseen.
inline bool all_surely_fine(const PointRow& row, const SegmentBounds& bounds, PartsAsked asked) {
  constexpr double within = 1 - 0x1p-30, least = 1e-100, most = 1e100;
  // Segment k of the row is number k + 1 here, between the points k and k + 1.
  double x[max_flagged + 2], y[max_flagged + 2], squares[max_flagged + 2], gaps[max_flagged + 2];
  std::int64_t outside[max_flagged + 1], odd = 0;
  const std::size_t first = row.has_before ? 0 : 1, last = row.count + (row.has_after ? 2 : 1);
  const Point* const points = row.points;
  const double* const parameters = row.parameters;
  for (std::size_t k = first; k < last; ++k) {
    const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(k);
    x[k] = points[at].x - points[at - 1].x;
    y[k] = points[at].y - points[at - 1].y;
    gaps[k] = parameters[at] - parameters[at - 1];
    squares[k] = x[k] * x[k] + y[k] * y[k];
    odd |= ((gaps[k] >= least) & (gaps[k] <= most)) ? 0 : 1;
  }
  flag_outside(points, row.count + 1, bounds.box, outside);
  for (std::size_t k = 0; k <= row.count; ++k) odd |= outside[k];

  const double longest = bounds.coarse * asked.max_length, longest_square = longest * longest * within;
  const double limit = longest_square < most ? longest_square : most;
  const double per_tolerance = 2 / (8 * asked.tolerance), bulge = bounds.coarse * bounds.coarse * within;
  const double hidden = bounds.visible * bounds.visible * within;
  const double unevenness = bounds.unevenness * bounds.unevenness * within;
  for (std::size_t k = first; k + 1 < last; ++k) {
    const double sine = std::fabs(x[k] * y[k + 1] - y[k] * x[k + 1]), dot = x[k] * x[k + 1] + y[k] * y[k + 1];
    const double longer = squares[k] > squares[k + 1] ? squares[k] : squares[k + 1];
    const double bend = sine * longer * per_tolerance, bound = bulge * dot;
    const bool flat = bend * bend <= bound * bound * (squares[k] + squares[k + 1] + (dot + dot));
    const double a = squares[k] * (gaps[k + 1] * gaps[k + 1]), b = squares[k + 1] * (gaps[k] * gaps[k]);
    const double larger = a > b ? a : b, smaller = a > b ? b : a;
    const bool even = (larger <= unevenness * smaller) | (longer < hidden);
    odd |= ((dot >= least) & (longer <= limit) & flat & even) ? 0 : 1;
  }
  return odd == 0;
}

inline LengthInBox sum_in_box(const Point* points, std::size_t count, const Box& box) {
  constexpr std::size_t columns = 8;
  double lengths[max_flagged + columns], sums[columns] = {};
  std::int64_t outside[max_flagged + 1], any = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double x = points[k + 1].x - points[k].x, y = points[k + 1].y - points[k].y;
    lengths[k] = __builtin_sqrt(x * x + y * y);
  }
  for (std::size_t k = 0; k < columns; ++k) lengths[count + k] = 0;
  for (std::size_t k = 0; k < count; k += columns) {
    for (std::size_t i = 0; i < columns; ++i) sums[i] += lengths[k + i];
  }
  flag_outside(points, count + 1, box, outside);
  for (std::size_t k = 0; k <= count; ++k) any |= outside[k];
  const double even = (sums[0] + sums[4]) + (sums[2] + sums[6]), odd = (sums[1] + sums[5]) + (sums[3] + sums[7]);
  return {even + odd, any == 0};
}

}  // namespace
}  // namespace lober::detail
