// Body of place_graded (kernels/all.inl).
#pragma once

#include "kernels/graded.hpp"
#include "kernels/widest.hpp"

namespace lober::detail {
namespace {

LOBER_INLINE double density_between(double around, double own) {
  const double low = own / 4, high = own * 4;
  const double least = around < low ? low : around, within = high < least ? high : least;
  return around < 0 ? own : within;
}

// The numbers that points between others are placed by, each along the segment that it lies on: the number of the
// point that counts from `index` on is m, and its place from + scale m / (a + sqrt(a^2 + growth m)).
template <typename V>
struct GradedPoints {
  static constexpr std::size_t most = 512, few = V::elements;
  double index[most + few], from[most + few], scale[most + few], a[most + few], growth[most + few];

  // Points first .. last, counted in these arrays. May write to those behind.
  LOBER_INLINE void set(std::size_t first, std::size_t last, double at, double start, double times, double begin,
                        double grows) {
    for (std::size_t k = first; k < last; k += few) {
      store_number(index + k, V(at));
      store_number(from + k, V(start));
      store_number(scale + k, V(times));
      store_number(a + k, V(begin));
      store_number(growth + k, V(grows));
    }
  }

  // The first `count` of them, whose numbers are n, n + 1, ...
  LOBER_INLINE void place(std::size_t n, std::size_t count, double* places) const {
    V numbers;
    for (std::size_t i = 0; i < few; ++i) numbers.v[i] = static_cast<double>(i);
    for (std::size_t k = 0; k < count; k += few) {
      const V m = V(static_cast<double>(n + k)) + numbers - load_number<V>(index + k), begin = load_number<V>(a + k);
      const V root = square_root(begin * begin + load_number<V>(growth + k) * m);
      const V place = load_number<V>(from + k) + load_number<V>(scale + k) * m / (begin + root);
      if (k + few <= count) {
        store_number(places + n + k, place);
      } else {
        for (std::size_t i = 0; i < count - k; ++i) places[n + k + i] = place.v[i];
      }
    }
  }
};

inline void place_all_graded(const GradedRow& row, double* places) {
  const double *parameters = row.parameters, *index = row.index, *required = row.required, *around = row.around;
  double a[max_graded], scale[max_graded], growth[max_graded];
  // Without a branch, so that compilers make vectors of it.
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
  GradedPoints<WidestNumbers> points;
  auto n = static_cast<std::size_t>(__builtin_ceil(index[0]));  // the first of the points that are gathered
  std::size_t gathered = 0;
  for (std::size_t k = 0; k < row.count; ++k) {
    const auto last = static_cast<std::size_t>(__builtin_ceil(index[k + 1]));
    while (n + gathered < last) {
      const std::size_t room = points.most - gathered, left = last - n - gathered;
      const std::size_t more = left < room ? left : room;
      points.set(gathered, gathered + more, index[k], parameters[k], scale[k], a[k], growth[k]);
      gathered += more;
      if (gathered < points.most) continue;
      points.place(n, gathered, places);
      n += gathered;
      gathered = 0;
    }
  }
  points.place(n, gathered, places);
}

}  // namespace
}  // namespace lober::detail
