#include "kernels/leaf.hpp"

#include "kernels/cpu.hpp"
#include "kernels/simd.hpp"

#include "kernels/leaf.inl"

namespace lober::detail {

void summarise_leaves_avx2(const Point* points, std::size_t first, std::size_t count, Box* boxes, DD* sums,
                           std::uint8_t* flags);
void summarise_leaves_avx512(const Point* points, std::size_t first, std::size_t count, Box* boxes, DD* sums,
                             std::uint8_t* flags);

void summarise_leaves(const Point* points, std::size_t first, std::size_t count, Box* boxes, DD* sums,
                      std::uint8_t* flags) {
  if (has_avx512()) {
    summarise_leaves_avx512(points, first, count, boxes, sums, flags);
  } else if (has_avx2()) {
    summarise_leaves_avx2(points, first, count, boxes, sums, flags);
  } else {
    summarise(points, first, count, boxes, sums, flags);
  }
}

}  // namespace lober::detail
