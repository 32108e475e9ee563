#include "kernels/sine.hpp"

#include "kernels/cpu.hpp"

#include "kernels/sine.inl"

namespace lober::detail {

void add_sines_avx2(double* y, const double* x, double factor, std::size_t count);

void add_sines(double* y, const double* x, double factor, std::size_t count) {
  if (has_avx2()) return add_sines_avx2(y, x, factor, count);
  add(y, x, factor, count);
}

}  // namespace lober::detail
