// Body of add_sines (kernels/all.inl).
#pragma once

#include <cstddef>

#include "kernels/trigonometric.hpp"

namespace lober::detail {
namespace {

inline void add_all_sines(double* __restrict y, const double* __restrict x, double factor, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) y[k] += factor * sine(x[k]);
}

}  // namespace
}  // namespace lober::detail
