// Body of chebyshev_points (kernels/all.inl).
#pragma once

#include <cstddef>

#include "kernels/chebyshev.hpp"
#include "kernels/widest.hpp"

namespace lober::detail {
namespace {

// Vectors of parameters at a time, so that the chains of additions hide behind each other and registers suffice.
// Compilers left to themselves compute one of the two coordinates number by number.
#ifdef __AVX512F__
constexpr std::size_t chebyshev_chains = 4;
#elif defined(__AVX2__)
constexpr std::size_t chebyshev_chains = 2;
#else
constexpr std::size_t chebyshev_chains = 1;
#endif

// x and y at chains * elements parameters.
template <std::size_t chains>
LOBER_INLINE void sum_chebyshev(const Point* coefficients, std::size_t degrees, double centre, double half_width,
                                const double* parameters, double* sums_x, double* sums_y) {
  using V = WidestNumbers;
  // b_{j+2}, b_{j+1} of both coordinates
  V x[chains], twice[chains], later_x[chains], latest_x[chains], later_y[chains], latest_y[chains];
  for (std::size_t i = 0; i < chains; ++i) {
    x[i] = (load_number<V>(parameters + i * V::elements) - V(centre)) / V(half_width);
    twice[i] = V(2) * x[i];
    later_x[i] = latest_x[i] = later_y[i] = latest_y[i] = V(0);
  }
  for (std::size_t j = degrees; j-- > 1;) {
    const V c_x(coefficients[j].x), c_y(coefficients[j].y);
    for (std::size_t i = 0; i < chains; ++i) {
      const V next_x = twice[i] * latest_x[i] + (c_x - later_x[i]);
      const V next_y = twice[i] * latest_y[i] + (c_y - later_y[i]);
      later_x[i] = latest_x[i];
      later_y[i] = latest_y[i];
      latest_x[i] = next_x;
      latest_y[i] = next_y;
    }
  }
  const V c_x(degrees == 0 ? 0 : coefficients[0].x), c_y(degrees == 0 ? 0 : coefficients[0].y);
  for (std::size_t i = 0; i < chains; ++i) {
    store_number(sums_x + i * V::elements, x[i] * latest_x[i] + (c_x - later_x[i]));
    store_number(sums_y + i * V::elements, x[i] * latest_y[i] + (c_y - later_y[i]));
  }
}

inline void evaluate_chebyshev(const Point* coefficients, std::size_t degrees, double centre, double half_width,
                               const double* parameters, std::size_t size, Point* points) {
  constexpr std::size_t few = WidestNumbers::elements, many = few * chebyshev_chains;
  double sums_x[many], sums_y[many];
  for (std::size_t first = 0; first < size;) {
    const std::size_t rest = size - first;
    std::size_t count = few;
    if (rest >= many) {
      count = many;
      sum_chebyshev<chebyshev_chains>(coefficients, degrees, centre, half_width, parameters + first, sums_x, sums_y);
    } else if (rest >= few) {
      sum_chebyshev<1>(coefficients, degrees, centre, half_width, parameters + first, sums_x, sums_y);
    } else {
      double last[few] = {};
      count = rest;
      for (std::size_t k = 0; k < rest; ++k) last[k] = parameters[first + k];
      sum_chebyshev<1>(coefficients, degrees, centre, half_width, last, sums_x, sums_y);
    }
    for (std::size_t k = 0; k < count; ++k) points[first + k] = {sums_x[k], sums_y[k]};
    first += count;
  }
}

}  // namespace
}  // namespace lober::detail
