#include "kernels/moments.hpp"
#include "kernels/simd.hpp"

#include "kernels/moments.inl"

namespace lober::detail {

Moments moments_of_quarters_avx2(const Point* points, std::size_t quarter, Point origin, double factor) {
  return moments_of_quarters(points, quarter, origin, factor);
}

}  // namespace lober::detail
