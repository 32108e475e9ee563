#include "kernels/leaf.hpp"
#include "kernels/simd.hpp"

#include "kernels/leaf.inl"

namespace lober::detail {

void summarise_leaves_avx512(const Point* points, std::size_t first, std::size_t count, Box* boxes, DD* sums,
                             std::uint8_t* flags) {
  summarise(points, first, count, boxes, sums, flags);
}

}  // namespace lober::detail
