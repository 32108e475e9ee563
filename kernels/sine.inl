// Compiled once for every machine and once for AVX2 (kernels/inline.hpp).
#include "kernels/trigonometric.hpp"

namespace {

inline void add(double* __restrict y, const double* __restrict x, double factor, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) y[k] += factor * lober::detail::sine(x[k]);
}

}  // namespace
