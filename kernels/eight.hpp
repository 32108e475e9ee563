// Eight doubles side by side, and the widest vector of the instruction set that a kernel is compiled for.
//
// `Eight` is a register of AVX-512 or two Lanes (kernels/simd.hpp): for sums of eight columns, which all instruction
// sets make in the same order, so that they give the same bits. `Widest` is an Eight with AVX-512 and Lanes elsewhere:
// for comparisons, where the order does not matter. Kernels for it are written once, with the functions below.
#pragma once

#include <cstddef>

#include "kernels/simd.hpp"

namespace lober::detail {

inline constexpr std::size_t eight = 8;

// Lanes, with the names that both have. Masks are joined by `both`, as those of AVX-512 are plain bits.
LOBER_INLINE LaneMask at_most(Lanes a, Lanes b) {
  return a <= b;
}
LOBER_INLINE LaneMask less(Lanes a, Lanes b) {
  return a < b;
}
LOBER_INLINE LaneMask equal(Lanes a, Lanes b) {
  return a == b;
}
LOBER_INLINE LaneMask both(LaneMask a, LaneMask b) {
  return a & b;
}
/// a where the mask is set, else b.
LOBER_INLINE Lanes choose(LaneMask mask, Lanes a, Lanes b) {
  return mask ? a : b;
}
/// The elements 0, 2, 4, ... of two in a row, and the others.
LOBER_INLINE Lanes evens(Lanes a, Lanes b) {
  return __builtin_shufflevector(a, b, 0, 2, 4, 6);
}
LOBER_INLINE Lanes odds(Lanes a, Lanes b) {
  return __builtin_shufflevector(a, b, 1, 3, 5, 7);
}
/// The same, each four in the order 0, 2, 1, 3, which AVX2 has in one step.
LOBER_INLINE Lanes evens_crosswise(Lanes a, Lanes b) {
  return __builtin_shufflevector(a, b, 0, 4, 2, 6);
}
LOBER_INLINE Lanes odds_crosswise(Lanes a, Lanes b) {
  return __builtin_shufflevector(a, b, 1, 5, 3, 7);
}

/// The pairs in the opposite order.
LOBER_INLINE Lanes pairs_reversed(Lanes a) {
  return __builtin_shufflevector(a, a, 2, 3, 0, 1);
}
/// a without its first element, and `last`.
LOBER_INLINE Lanes followed_by(Lanes a, double last) {
  return __builtin_shufflevector(a, splat(last), 1, 2, 3, 4);
}
/// The last element of `before`, then a without its last one.
LOBER_INLINE Lanes preceded_by(Lanes a, Lanes before) {
  return __builtin_shufflevector(before, a, 3, 4, 5, 6);
}

#ifdef __AVX512F__

using Eight = double __attribute__((vector_size(64)));
using EightMask = __mmask8;

LOBER_INLINE Eight side_by_side(Lanes low, Lanes high) {
  return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
}
LOBER_INLINE Lanes low_half(Eight a) {
  return __builtin_shufflevector(a, a, 0, 1, 2, 3);
}
LOBER_INLINE Lanes high_half(Eight a) {
  return __builtin_shufflevector(a, a, 4, 5, 6, 7);
}
LOBER_INLINE Eight splat_eight(double value) {
  return Eight{value, value, value, value, value, value, value, value};
}
LOBER_INLINE void store(double* to, Eight value) {
  std::memcpy(to, &value, sizeof value);
}
// The forms without a mask make GCC 12 warn of its own header.
LOBER_INLINE Eight min(Eight a, Eight b) {
  return _mm512_maskz_min_pd(0xff, a, b);
}
LOBER_INLINE Eight max(Eight a, Eight b) {
  return _mm512_maskz_max_pd(0xff, a, b);
}
LOBER_INLINE Eight absolute(Eight a) {
  return _mm512_abs_pd(a);
}
LOBER_INLINE EightMask at_most(Eight a, Eight b) {
  return _mm512_cmp_pd_mask(a, b, _CMP_LE_OQ);
}
LOBER_INLINE EightMask less(Eight a, Eight b) {
  return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ);
}
LOBER_INLINE EightMask equal(Eight a, Eight b) {
  return _mm512_cmp_pd_mask(a, b, _CMP_EQ_OQ);
}
LOBER_INLINE EightMask both(EightMask a, EightMask b) {
  return static_cast<EightMask>(a & b);
}
LOBER_INLINE Eight choose(EightMask mask, Eight a, Eight b) {
  return _mm512_mask_blend_pd(mask, b, a);
}
LOBER_INLINE unsigned mask_bits(EightMask mask) {
  return mask;
}
LOBER_INLINE Eight evens(Eight a, Eight b) {
  return __builtin_shufflevector(a, b, 0, 2, 4, 6, 8, 10, 12, 14);
}
LOBER_INLINE Eight odds(Eight a, Eight b) {
  return __builtin_shufflevector(a, b, 1, 3, 5, 7, 9, 11, 13, 15);
}
LOBER_INLINE Eight evens_crosswise(Eight a, Eight b) {
  return __builtin_shufflevector(a, b, 0, 4, 2, 6, 8, 12, 10, 14);
}
LOBER_INLINE Eight odds_crosswise(Eight a, Eight b) {
  return __builtin_shufflevector(a, b, 1, 5, 3, 7, 9, 13, 11, 15);
}
LOBER_INLINE Eight pairs_reversed(Eight a) {
  return __builtin_shufflevector(a, a, 6, 7, 4, 5, 2, 3, 0, 1);
}
LOBER_INLINE Eight followed_by(Eight a, double last) {
  return __builtin_shufflevector(a, splat_eight(last), 1, 2, 3, 4, 5, 6, 7, 8);
}
LOBER_INLINE Eight preceded_by(Eight a, Eight before) {
  return __builtin_shufflevector(before, a, 7, 8, 9, 10, 11, 12, 13, 14);
}
/// Zeros in the first `by` places, then the elements from the first one on.
template <int by>
LOBER_INLINE Eight moved_up(Eight a) {
  constexpr int from = eight - by;
  return __builtin_shufflevector(Eight{}, a, from, from + 1, from + 2, from + 3, from + 4, from + 5, from + 6,
                                 from + 7);
}
LOBER_INLINE double last_of(Eight a) {
  return a[7];
}
LOBER_INLINE Eight product_error(Eight a, Eight b, Eight product) {
  return _mm512_fmsub_pd(a, b, product);
}

using Widest = Eight;
LOBER_INLINE Eight eight_of(const Eight (&parts)[1]) {
  return parts[0];
}
LOBER_INLINE Eight part_of(Eight a, std::size_t /*index*/) {
  return a;
}

#else

struct Eight {
  Lanes low, high;
  LOBER_INLINE friend Eight operator+(Eight a, Eight b) { return {a.low + b.low, a.high + b.high}; }
  LOBER_INLINE friend Eight operator-(Eight a, Eight b) { return {a.low - b.low, a.high - b.high}; }
};

LOBER_INLINE Lanes low_half(Eight a) {
  return a.low;
}
LOBER_INLINE Lanes high_half(Eight a) {
  return a.high;
}
LOBER_INLINE Eight splat_eight(double value) {
  return {splat(value), splat(value)};
}
/// Zeros in the first `by` places, then the elements from the first one on.
template <int by>
LOBER_INLINE Eight moved_up(Eight a) {
  if constexpr (by == lanes) return {splat(0), a.low};
  return {__builtin_shufflevector(splat(0), a.low, 4 - by, 5 - by, 6 - by, 7 - by),
          __builtin_shufflevector(a.low, a.high, 4 - by, 5 - by, 6 - by, 7 - by)};
}
LOBER_INLINE double last_of(Eight a) {
  return a.high[3];
}

using Widest = Lanes;
LOBER_INLINE Eight eight_of(const Lanes (&parts)[2]) {
  return {parts[0], parts[1]};
}
LOBER_INLINE Lanes part_of(Eight a, std::size_t index) {
  return index == 0 ? a.low : a.high;
}

#endif

inline constexpr std::size_t widest = sizeof(Widest) / sizeof(double);
/// An Eight is this number of Widest.
inline constexpr std::size_t parts_of_eight = eight / widest;

LOBER_INLINE Widest load_widest(const double* from) {
  Widest value;
  std::memcpy(&value, from, sizeof value);
  return value;
}
LOBER_INLINE Widest splat_widest(double value) {
  return part_of(splat_eight(value), 0);
}
/// Four numbers, repeated.
LOBER_INLINE Widest repeat(Lanes four) {
#ifdef __AVX512F__
  return side_by_side(four, four);
#else
  return four;
#endif
}
/// Lanes with the least and the greatest elements that are 4 apart.
LOBER_INLINE Lanes least_four(Widest a) {
#ifdef __AVX512F__
  return min(low_half(a), high_half(a));
#else
  return a;
#endif
}
LOBER_INLINE Lanes greatest_four(Widest a) {
#ifdef __AVX512F__
  return max(low_half(a), high_half(a));
#else
  return a;
#endif
}

}  // namespace lober::detail
