// As many doubles side by side as the instruction set has in a vector, for kernels whose elements know nothing of one
// another: then their number does not change any bits.
#pragma once

#include "kernels/simd.hpp"

namespace lober::detail {
namespace {

#ifdef __AVX512F__
constexpr std::size_t value_lanes = 8;
#else
constexpr std::size_t value_lanes = lanes;
#endif
using Values = double __attribute__((vector_size(8 * value_lanes)));
using ValueMask = std::int64_t __attribute__((vector_size(8 * value_lanes)));

LOBER_INLINE Values values_at(const double* from) {
  Values values;
  __builtin_memcpy(&values, from, sizeof values);
  return values;
}
LOBER_INLINE void store_values(double* to, Values values) {
  __builtin_memcpy(to, &values, sizeof values);
}
LOBER_INLINE Values all_of(double value) {
  return value - Values{};
}
LOBER_INLINE Values magnitude_of(Values a) {
  return __builtin_bit_cast(Values, __builtin_bit_cast(ValueMask, a) & 0x7fffffffffffffff);
}
LOBER_INLINE Values greater(Values a, Values b) {
  return a < b ? b : a;
}
LOBER_INLINE Values select(ValueMask mask, Values a, Values b) {
  return mask ? a : b;
}
LOBER_INLINE Values root_of(Values a) {
#ifdef __AVX512F__
  return _mm512_maskz_sqrt_pd(0xff, a);  // the form without a mask makes GCC 12 warn of its own header
#else
  return square_root(a);
#endif
}
// Bit k is that of lane k.
LOBER_INLINE unsigned bits_of(ValueMask mask) {
#ifdef __AVX512F__
  return _mm512_movepi64_mask(__builtin_bit_cast(__m512i, mask));
#else
  return mask_bits(mask);
#endif
}
LOBER_INLINE ValueMask mask_of(unsigned bits) {
#ifdef __AVX512F__
  return __builtin_bit_cast(ValueMask, _mm512_movm_epi64(static_cast<__mmask8>(bits)));
#else
  const auto all = static_cast<std::int64_t>(bits);
  return (ValueMask{all, all, all, all} & ValueMask{1, 2, 4, 8}) != 0;
#endif
}

}  // namespace
}  // namespace lober::detail
