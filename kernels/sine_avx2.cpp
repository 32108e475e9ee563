#include <cstddef>

#include "kernels/sine.inl"

namespace lober::detail {

void add_sines_avx2(double* y, const double* x, double factor, std::size_t count) {
  add(y, x, factor, count);
}

}  // namespace lober::detail
