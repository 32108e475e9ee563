// N doubles side by side as one number, for formulas that are written once for any kind of number.
//
// The instruction set is a part of the type: two compiled copies of one template then differ in their names, and the
// linker cannot take the copy of a newer processor for the whole program. Every operation is that of IEEE 754 on each
// element, so that an element has the bits of the same computation with plain doubles.
#pragma once

#include <cstddef>
#include <cstdint>
#ifdef __SSE2__
#include <immintrin.h>
#endif

#include "kernels/cpu.hpp"
#include "kernels/inline.hpp"

namespace lober::detail {

template <int N>
struct VectorOf;
template <>
struct VectorOf<4> {
  using Numbers = double __attribute__((vector_size(32)));
  using Bits = std::int64_t __attribute__((vector_size(32)));
};
template <>
struct VectorOf<8> {
  using Numbers = double __attribute__((vector_size(64)));
  using Bits = std::int64_t __attribute__((vector_size(64)));
};

template <int N, InstructionSet isa>
struct Wide {
  static constexpr int elements = N;
  using Vector = typename VectorOf<N>::Numbers;
  using Mask = typename VectorOf<N>::Bits;

  Vector v;

  Wide() = default;
  LOBER_INLINE Wide(Vector vector) : v(vector) {}
  LOBER_INLINE Wide(double value) : v(value - Vector{}) {}  // NOLINT: a number is a number

  LOBER_INLINE friend Wide operator+(Wide a, Wide b) { return a.v + b.v; }
  LOBER_INLINE friend Wide operator-(Wide a, Wide b) { return a.v - b.v; }
  LOBER_INLINE friend Wide operator*(Wide a, Wide b) { return a.v * b.v; }
  LOBER_INLINE friend Wide operator/(Wide a, Wide b) { return a.v / b.v; }
  LOBER_INLINE friend Wide operator-(Wide a) { return -a.v; }
  LOBER_INLINE Wide& operator+=(Wide b) {
    v += b.v;
    return *this;
  }
};

/// The numbers at from[0], from[1] ...
template <typename V>
LOBER_INLINE V load_number(const double* from) {
  V result;
  __builtin_memcpy(&result, from, sizeof result);
  return result;
}
template <typename V>
LOBER_INLINE void store_number(double* to, V value) {
  __builtin_memcpy(to, &value, sizeof value);
}

/// The number at each of from[0], from[1] ..., plus `offset`.
template <typename V>
LOBER_INLINE V gather_number(const double* const* from, std::size_t offset) {
  if constexpr (sizeof(V) == sizeof(double)) {
    return from[0][offset];
  } else if constexpr (V::elements == 4) {
    return V(typename V::Vector{from[0][offset], from[1][offset], from[2][offset], from[3][offset]});
  } else {
    static_assert(V::elements == 8);
    return V(typename V::Vector{from[0][offset], from[1][offset], from[2][offset], from[3][offset], from[4][offset],
                                from[5][offset], from[6][offset], from[7][offset]});
  }
}

/// The greater one; b where a is NaN.
LOBER_INLINE double greater_number(double a, double b) {
  return a > b ? a : b;
}
template <int N, InstructionSet isa>
LOBER_INLINE Wide<N, isa> greater_number(Wide<N, isa> a, Wide<N, isa> b) {
  return a.v > b.v ? a.v : b.v;
}

LOBER_INLINE double magnitude(double a) {
  return __builtin_fabs(a);
}
template <int N, InstructionSet isa>
LOBER_INLINE Wide<N, isa> magnitude(Wide<N, isa> a) {
  using W = Wide<N, isa>;
  const typename W::Mask bits = __builtin_bit_cast(typename W::Mask, a.v) & 0x7fffffffffffffff;
  return __builtin_bit_cast(typename W::Vector, bits);
}

LOBER_INLINE double square_root(double a) {
  return __builtin_sqrt(a);
}
template <int N, InstructionSet isa>
LOBER_INLINE Wide<N, isa> square_root(Wide<N, isa> a) {
#ifdef __AVX512F__
  // The form without a mask makes GCC 12 warn of its own header.
  if constexpr (N == 8) return typename Wide<N, isa>::Vector(_mm512_maskz_sqrt_pd(0xff, a.v));
#endif
#ifdef __AVX__
  if constexpr (N == 4) return typename Wide<N, isa>::Vector(_mm256_sqrt_pd(a.v));
#endif
  for (int k = 0; k < N; ++k) a.v[k] = __builtin_sqrt(a.v[k]);
  return a;
}

/// x, negated where the last bit of `whole` is set.
LOBER_INLINE double negated_if_odd(double x, double whole) {
  const std::uint64_t sign = __builtin_bit_cast(std::uint64_t, whole) << 63U;
  return __builtin_bit_cast(double, __builtin_bit_cast(std::uint64_t, x) ^ sign);
}
template <int N, InstructionSet isa>
LOBER_INLINE Wide<N, isa> negated_if_odd(Wide<N, isa> x, Wide<N, isa> whole) {
  using W = Wide<N, isa>;
  const typename W::Mask sign = __builtin_bit_cast(typename W::Mask, whole.v) << 63;
  return __builtin_bit_cast(typename W::Vector, __builtin_bit_cast(typename W::Mask, x.v) ^ sign);
}

}  // namespace lober::detail
