// Body of place_graded (kernels/all.inl).
#pragma once

#include "kernels/graded.hpp"
#include "kernels/simd.hpp"

namespace lober::detail {
namespace {

LOBER_INLINE double density_between(double around, double own) {
  const double low = own / 4, high = own * 4;
  const double least = around < low ? low : around, within = high < least ? high : least;
  return around < 0 ? own : within;
}

// Point m behind the beginning of a segment, m a number, lies at from + scale m / (a + sqrt(a^2 + growth m)).
struct GradedSegments {
  double a[max_graded], scale[max_graded], growth[max_graded];

  // Without a branch, so that compilers make vectors of it.
  LOBER_INLINE explicit GradedSegments(const GradedRow& row) {
    const double *parameters = row.parameters, *index = row.index, *required = row.required, *around = row.around;
    for (std::size_t k = 0; k < row.count; ++k) {
      const double gap = parameters[k + 1] - parameters[k], per_width = 1 / (index[k + 1] - index[k]);
      const double own = (required[k] + required[k]) / (gap + gap);
      const double first = density_between(around[k], own), last = density_between(around[k + 1], own);
      // Where no density is known, any that does not vary.
      const double begin = own > 0 ? first : 1, end = own > 0 ? last : 1;
      a[k] = begin;
      scale[k] = gap * (begin + end) * per_width;
      growth[k] = (end - begin) * (end + begin) * per_width;
    }
  }
};

// The numbers of points on one segment are few, and differ: several places at a time, of which those behind the last
// one are overwritten by the next segment's.
inline void place_all_graded(const GradedRow& row, double* places) {
  const GradedSegments segments(row);
  const auto number_behind = [&](std::size_t k) { return static_cast<std::size_t>(__builtin_ceil(row.index[k])); };
  const std::size_t end = number_behind(row.count);
  std::size_t n = number_behind(0);
  for (std::size_t k = 0; k < row.count; ++k) {
    const std::size_t last = number_behind(k + 1);
    const Lanes from = splat(row.parameters[k]), a = splat(segments.a[k]);
    const Lanes scale = splat(segments.scale[k]), growth = splat(segments.growth[k]);
    for (; n < last; n += lanes) {
      const Lanes m = splat(static_cast<double>(n)) + Lanes{0, 1, 2, 3} - splat(row.index[k]);
      const Lanes place = from + scale * m / (a + square_root(a * a + growth * m));
      if (n + lanes <= end) {
        store(places + n, place);
      } else {
        for (std::size_t i = 0; n + i < last; ++i) places[n + i] = place[i];
      }
    }
    n = last;
  }
}

}  // namespace
}  // namespace lober::detail
