#include "kernels/interpolation.hpp"
#include "kernels/simd.hpp"

#include "kernels/interpolation.inl"

namespace lober::detail {

void subdivide_avx2(const CubicPiece& piece, std::uint32_t parts, std::uint32_t first, std::uint32_t last, Point* out) {
  subdivide_with(piece, parts, first, last, out);
}

}  // namespace lober::detail
