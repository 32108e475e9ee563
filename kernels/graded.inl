// Body of place_graded (kernels/all.inl).
#pragma once

#include "kernels/graded.hpp"
#include "kernels/widest.hpp"

namespace lober::detail {
namespace {

// The density at the ends of a segment, and its own.
struct Grade {
  double a, b, own;
};

// Points n, n + 1, ... of the segment that begins at `from`, at index `index`, and takes up `width` of it.
template <typename V>
LOBER_INLINE V graded_place(V n, double index, double width, double from, double gap, Grade grade) {
  const double a = grade.a, b = grade.b;
  const V part = (n - V(index)) / V(width);
  const V root = square_root(V(a * a) + V((b - a) * (b + a)) * part);
  const V t = grade.own > 0 ? part * V(a + b) / (V(a) + root) : part;
  return V(from) + V(gap) * t;
}

LOBER_INLINE double density_between(double around, double own) {
  const double low = own / 4, high = own * 4;
  const double least = around < low ? low : around, within = high < least ? high : least;
  return around < 0 ? own : within;
}

inline void place_all_graded(const GradedRow& row, double* places, std::size_t end) {
  using V = WidestNumbers;
  constexpr std::size_t few = V::elements;
  V numbers;
  for (std::size_t i = 0; i < few; ++i) numbers.v[i] = static_cast<double>(i);
  double own[max_graded], a[max_graded], b[max_graded];
  for (std::size_t k = 0; k < row.count; ++k) {
    const double gap = row.parameters[k + 1] - row.parameters[k];
    own[k] = (row.required[k] + row.required[k]) / (gap + gap);
    a[k] = density_between(row.around[k], own[k]);
    b[k] = density_between(row.around[k + 1], own[k]);
  }
  for (std::size_t k = 0; k < row.count; ++k) {
    const double index = row.index[k], last = row.index[k + 1], width = last - index;
    const double from = row.parameters[k], gap = row.parameters[k + 1] - from;
    double at = __builtin_ceil(index);
    auto n = static_cast<std::size_t>(at);
    for (; at < last && n + few <= end; at += static_cast<double>(few), n += few) {
      store_number(places + n, graded_place(V(at) + numbers, index, width, from, gap, {a[k], b[k], own[k]}));
    }
    for (; at < last; at += 1, ++n) places[n] = graded_place(at, index, width, from, gap, {a[k], b[k], own[k]});
  }
}

}  // namespace
}  // namespace lober::detail
