#include <cstddef>

#include "kernels/chebyshev.hpp"

#include "kernels/chebyshev.inl"

namespace lober::detail {

void chebyshev_points_avx2(const Point* coefficients, std::size_t degrees, double centre, double half_width,
                           const double* parameters, std::size_t size, Point* points) {
  evaluate(coefficients, degrees, centre, half_width, parameters, size, points);
}

}  // namespace lober::detail
