#include "kernels/chebyshev.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "kernels/elementary.hpp"
#include "kernels/kernel_table.hpp"

namespace lober::detail {

void chebyshev_points(std::span<const Point> coefficients, double centre, double half_width,
                      std::span<const double> parameters, std::span<Point> points) {
  kernels().chebyshev_points(coefficients.data(), coefficients.size(), centre, half_width, parameters.data(),
                             parameters.size(), points.data());
}

std::span<const Point> without_roundings(std::span<const Point> coefficients) {
  double sum_x = 0, sum_y = 0;
  for (const Point c : coefficients) {
    sum_x += std::fabs(c.x);
    sum_y += std::fabs(c.y);
  }
  const double rounding = std::numeric_limits<double>::epsilon() / 2;
  std::size_t size = coefficients.size();
  while (size > 1 && std::fabs(coefficients[size - 1].x) <= rounding * sum_x &&
         std::fabs(coefficients[size - 1].y) <= rounding * sum_y) {
    --size;
  }
  return coefficients.first(size);
}

void chebyshev_coefficients(std::span<const Point> points, std::span<Point> coefficients) {
  const std::size_t count = points.size();
  for (std::size_t j = 0; j < count; ++j) {
    Point sum;
    for (std::size_t k = 0; k < count; ++k) {
      // The angle j (2 k + 1) pi / (2 count), reduced exactly.
      const std::size_t turns = j * (2 * k + 1) % (4 * count);
      const double weight =
          elementary::cos(std::numbers::pi * static_cast<double>(turns) / static_cast<double>(2 * count));
      sum.x += weight * points[k].x;
      sum.y += weight * points[k].y;
    }
    const double scale = (j == 0 ? 1.0 : 2.0) / static_cast<double>(count);
    coefficients[j] = {scale * sum.x, scale * sum.y};
  }
}

double chebyshev_node(std::size_t k, std::size_t count) {
  return elementary::cos(std::numbers::pi * (static_cast<double>(k) + 0.5) / static_cast<double>(count));
}

}  // namespace lober::detail
