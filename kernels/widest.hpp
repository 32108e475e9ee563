// The widest vector of the instruction set that a kernel is compiled for, as a number (kernels/wide.hpp).
#pragma once

#include "kernels/wide.hpp"

namespace lober::detail {
namespace {

#ifdef __AVX512F__
using WidestNumbers = Wide<8, InstructionSet::avx512>;
#elif defined(__AVX2__)
using WidestNumbers = Wide<4, InstructionSet::avx2>;
#else
using WidestNumbers = Wide<4, InstructionSet::baseline>;
#endif

}  // namespace
}  // namespace lober::detail
