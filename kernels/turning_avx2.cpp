#include "kernels/turning.hpp"

#include "kernels/turning.inl"

namespace lober::detail {

void turns_along_avx2(const Point* points, std::size_t segments, double* lengths, double* curvatures) {
  turns(points, segments, lengths, curvatures);
}

void parts_needed_avx2(const double* lengths, const double* curvatures, std::size_t count, PartsAsked asked,
                       double* needed) {
  parts(lengths, curvatures, count, asked, needed);
}

}  // namespace lober::detail
