#include <algorithm>
#include <array>
#include <cstddef>

#include "kernels/chebyshev.hpp"

#include "kernels/chebyshev.inl"

namespace lober {

void chebyshev_points_avx2(std::span<const Point> coefficients, double centre, double half_width,
                           std::span<const double> parameters, std::span<Point> points) {
  evaluate(coefficients, centre, half_width, parameters, points);
}

}  // namespace lober
