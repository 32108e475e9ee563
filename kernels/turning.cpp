#include "kernels/turning.hpp"

#include "kernels/cpu.hpp"

#include "kernels/turning.inl"

namespace lober::detail {

void turns_along_avx2(const Point* points, std::size_t segments, double* lengths, double* curvatures);
void parts_needed_avx2(const double* lengths, const double* curvatures, std::size_t count, PartsAsked asked,
                       double* parts);

void turns_along(const Point* points, std::size_t segments, double* lengths, double* curvatures) {
  if (has_avx2()) {
    turns_along_avx2(points, segments, lengths, curvatures);
  } else {
    turns(points, segments, lengths, curvatures);
  }
}

void parts_needed(const double* lengths, const double* curvatures, std::size_t count, PartsAsked asked,
                  double* needed) {
  if (has_avx2()) {
    parts_needed_avx2(lengths, curvatures, count, asked, needed);
  } else {
    parts(lengths, curvatures, count, asked, needed);
  }
}

}  // namespace lober::detail
