// Body of chebyshev_points (kernels/all.inl).
#pragma once

#include <cstddef>

#include "kernels/chebyshev.hpp"

namespace lober::detail {
namespace {

// So many parameters at a time that the chains of additions hide behind each other.
constexpr std::size_t parameters_at_once = 8;

inline void evaluate_chebyshev(const Point* coefficients, std::size_t degrees, double centre, double half_width,
                               const double* parameters, std::size_t size, Point* points) {
  for (std::size_t first = 0; first < size; first += parameters_at_once) {
    const std::size_t count = size - first < parameters_at_once ? size - first : parameters_at_once;
    // b_{j+2}, b_{j+1} of both coordinates
    double x[parameters_at_once]{}, later_x[parameters_at_once]{}, latest_x[parameters_at_once]{},
        later_y[parameters_at_once]{}, latest_y[parameters_at_once]{};
    for (std::size_t k = 0; k < count; ++k) x[k] = (parameters[first + k] - centre) / half_width;
    for (std::size_t j = degrees; j-- > 1;) {
      const Point c = coefficients[j];
      for (std::size_t k = 0; k < parameters_at_once; ++k) {
        const double next_x = 2 * x[k] * latest_x[k] + (c.x - later_x[k]);
        const double next_y = 2 * x[k] * latest_y[k] + (c.y - later_y[k]);
        later_x[k] = latest_x[k];
        later_y[k] = latest_y[k];
        latest_x[k] = next_x;
        latest_y[k] = next_y;
      }
    }
    const Point c = degrees == 0 ? Point{} : coefficients[0];
    for (std::size_t k = 0; k < count; ++k) {
      points[first + k] = {x[k] * latest_x[k] + (c.x - later_x[k]), x[k] * latest_y[k] + (c.y - later_y[k])};
    }
  }
}

}  // namespace
}  // namespace lober::detail
