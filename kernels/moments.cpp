#include "kernels/moments.hpp"

#include "kernels/kernel_table.hpp"
#include "kernels/simd.hpp"

namespace lober::detail {

Moments moments_of_segment(Point a, Point b, Point origin, double factor) {
  const DD ax = two_diff(a.x * factor, origin.x), ay = two_diff(a.y * factor, origin.y);
  const DD bx = two_diff(b.x * factor, origin.x), by = two_diff(b.y * factor, origin.y);
  const DD term = cross(ax, ay, bx, by);
  return {term, term * (ax + bx), term * (ay + by)};
}

Moments moments_along(const Point* points, std::size_t count, Point origin, double factor) {
  const std::size_t quarter = count / lanes;
  Moments sum;
  if (quarter > 0) sum = kernels().moments_of_quarters(points, quarter, origin, factor);
  for (std::size_t k = quarter * lanes; k < count; ++k) {
    sum += moments_of_segment(points[k], points[k + 1], origin, factor);
  }
  return sum;
}

}  // namespace lober::detail
