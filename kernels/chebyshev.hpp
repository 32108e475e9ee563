// Curves given by Chebyshev polynomials.
#pragma once

#include <span>

#include "kernels/point.hpp"

namespace lober::detail {

/// points[k] = sum over j of coefficients[j] T_j(x_k), x_k = (parameters[k] - centre) / half_width, by Clenshaw's
/// recurrence. A parameter gives the same bits wherever it stands in the span. Backward stable for |x| <= 1.
void chebyshev_points(std::span<const Point> coefficients, double centre, double half_width,
                      std::span<const double> parameters, std::span<Point> points);

/// The coefficients without those behind the last one that is larger than what rounding makes of all: half an ulp of
/// the sum of their magnitudes. For |x| <= 1 each of the others changes the sum by no more than that.
[[nodiscard]] std::span<const Point> without_roundings(std::span<const Point> coefficients);

/// The coefficients of the polynomial of degree points.size() - 1 through `points`, taken at the parameters
/// chebyshev_node(k, points.size()). O(n^2).
void chebyshev_coefficients(std::span<const Point> points, std::span<Point> coefficients);

/// cos(pi (k + 1/2) / count): descending from near 1 to near -1.
[[nodiscard]] double chebyshev_node(std::size_t k, std::size_t count);

}  // namespace lober::detail
