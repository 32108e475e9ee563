// As many doubles side by side as the instruction set has in a vector, for kernels whose elements know nothing of one
// another: then their number does not change any bits.
#pragma once

#include "kernels/simd.hpp"
#include "kernels/widest.hpp"

namespace lober::detail {
namespace {

constexpr std::size_t value_lanes = WidestNumbers::elements;
using Values = WidestNumbers::Vector;
using ValueMask = WidestNumbers::Mask;

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
  return magnitude(WidestNumbers(a)).v;
}
LOBER_INLINE Values greater(Values a, Values b) {
  return a < b ? b : a;
}
LOBER_INLINE Values select(ValueMask mask, Values a, Values b) {
  return mask ? a : b;
}
LOBER_INLINE Values root_of(Values a) {
  return square_root(WidestNumbers(a)).v;
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

#ifdef __AVX512F__
// Swaps rows and columns of an 8 x 8 block.
LOBER_INLINE void turn_block(Values (&b)[8]) {
  Values a[8];
  for (std::size_t k = 0; k < 8; k += 2) {
    a[k] = __builtin_shufflevector(b[k], b[k + 1], 0, 8, 2, 10, 4, 12, 6, 14);
    a[k + 1] = __builtin_shufflevector(b[k], b[k + 1], 1, 9, 3, 11, 5, 13, 7, 15);
  }
  Values c[8];
  constexpr std::size_t upper[4] = {0, 1, 4, 5};
  for (const std::size_t k : upper) {
    c[k] = __builtin_shufflevector(a[k], a[k + 2], 0, 1, 8, 9, 4, 5, 12, 13);
    c[k + 2] = __builtin_shufflevector(a[k], a[k + 2], 2, 3, 10, 11, 6, 7, 14, 15);
  }
  for (std::size_t k = 0; k < 4; ++k) {
    b[k] = __builtin_shufflevector(c[k], c[k + 4], 0, 1, 2, 3, 8, 9, 10, 11);
    b[k + 4] = __builtin_shufflevector(c[k], c[k + 4], 4, 5, 6, 7, 12, 13, 14, 15);
  }
}
#endif
// Eight doubles at each of some addresses, column by column.
LOBER_INLINE void load_rows(const double* const* from, Values (&columns)[8]) {
#ifdef __AVX512F__
  for (std::size_t k = 0; k < 8; ++k) columns[k] = values_at(from[k]);
  turn_block(columns);
#else
  for (std::size_t half = 0; half < 8; half += lanes) {
    Lanes rows[lanes];
    for (std::size_t k = 0; k < lanes; ++k) rows[k] = load(from[k] + half);
    transpose(rows);
    for (std::size_t k = 0; k < lanes; ++k) columns[half + k] = rows[k];
  }
#endif
}
// The inverse, to the first `count` addresses.
LOBER_INLINE void store_rows(Values (&columns)[8], double* const* to, std::size_t count) {
#ifdef __AVX512F__
  turn_block(columns);
  for (std::size_t k = 0; k < count; ++k) store_values(to[k], columns[k]);
#else
  for (std::size_t half = 0; half < 8; half += lanes) {
    Lanes rows[lanes];
    for (std::size_t k = 0; k < lanes; ++k) rows[k] = columns[half + k];
    transpose(rows);
    for (std::size_t k = 0; k < count; ++k) store(to[k] + half, rows[k]);
  }
#endif
}

}  // namespace
}  // namespace lober::detail
