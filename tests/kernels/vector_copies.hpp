// The copies of the kernels that are held against the plain one.
#pragma once

#include <vector>

#include "kernels/cpu.hpp"
#include "kernels/kernel_table.hpp"

namespace lober::test {

/// Those of this processor for AVX2 and AVX-512, as far as LOBER_ISA allows them; empty where only the plain one runs.
inline std::vector<const detail::KernelTable*> vector_copies() {
  std::vector<const detail::KernelTable*> copies;
  if (detail::has_avx2()) copies.push_back(&detail::avx2_kernels);
  if (detail::has_avx512()) copies.push_back(&detail::avx512_kernels);
  return copies;
}

}  // namespace lober::test
