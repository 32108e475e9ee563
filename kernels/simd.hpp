// Four doubles side by side, in the compiler's portable vector type.
//
// A kernel that is worth it is written once over `Lanes` in a *.inl file, which is compiled for plain x86-64 (each
// Lanes is two SSE2 registers; any other machine works too), for AVX2 + FMA and for AVX-512 (kernels/all.inl). Lanes
// hold independent sums that are joined in a fixed order, and the one thing that FMA changes, the error of a product,
// is exact either way, so all give the same bits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#ifdef __AVX2__
#include <immintrin.h>
#endif

#include "kernels/inline.hpp"

namespace lober::detail {

using Lanes = double __attribute__((vector_size(32)));
using LaneMask = std::int64_t __attribute__((vector_size(32)));
inline constexpr std::size_t lanes = 4;

LOBER_INLINE Lanes load(const double* from) {
  Lanes value;
  std::memcpy(&value, from, sizeof value);
  return value;
}
LOBER_INLINE void store(double* to, Lanes value) {
  std::memcpy(to, &value, sizeof value);
}
LOBER_INLINE Lanes splat(double value) {
  return Lanes{value, value, value, value};
}
#ifdef __AVX2__
LOBER_INLINE Lanes min(Lanes a, Lanes b) {
  return _mm256_min_pd(a, b);
}
LOBER_INLINE Lanes max(Lanes a, Lanes b) {
  return _mm256_max_pd(a, b);
}
#else
LOBER_INLINE Lanes min(Lanes a, Lanes b) {
  return a < b ? a : b;
}
LOBER_INLINE Lanes max(Lanes a, Lanes b) {
  return a > b ? a : b;
}
#endif

LOBER_INLINE Lanes absolute(Lanes a) {
  constexpr std::int64_t all_but_sign = 0x7fffffffffffffff;
  const LaneMask bits = reinterpret_cast<LaneMask>(a) & all_but_sign;
  return reinterpret_cast<Lanes>(bits);
}

LOBER_INLINE Lanes square_root(Lanes a) {
#ifdef __AVX2__
  return _mm256_sqrt_pd(a);
#else
  return Lanes{__builtin_sqrt(a[0]), __builtin_sqrt(a[1]), __builtin_sqrt(a[2]), __builtin_sqrt(a[3])};
#endif
}

/// The least and the greatest of the four.
LOBER_INLINE double least(Lanes a) {
  const double first = a[1] < a[0] ? a[1] : a[0], second = a[3] < a[2] ? a[3] : a[2];
  return second < first ? second : first;
}
LOBER_INLINE double greatest(Lanes a) {
  const double first = a[0] < a[1] ? a[1] : a[0], second = a[2] < a[3] ? a[3] : a[2];
  return first < second ? second : first;
}

/// Swaps rows and columns of a 4 x 4 block.
LOBER_INLINE void transpose(Lanes (&row)[lanes]) {
  const Lanes a = __builtin_shufflevector(row[0], row[1], 0, 4, 2, 6);
  const Lanes b = __builtin_shufflevector(row[0], row[1], 1, 5, 3, 7);
  const Lanes c = __builtin_shufflevector(row[2], row[3], 0, 4, 2, 6);
  const Lanes d = __builtin_shufflevector(row[2], row[3], 1, 5, 3, 7);
  row[0] = __builtin_shufflevector(a, c, 0, 1, 4, 5);
  row[1] = __builtin_shufflevector(b, d, 0, 1, 4, 5);
  row[2] = __builtin_shufflevector(a, c, 2, 3, 6, 7);
  row[3] = __builtin_shufflevector(b, d, 2, 3, 6, 7);
}

/// Bit k is set where lane k of the mask is true.
LOBER_INLINE unsigned mask_bits(LaneMask mask) {
#ifdef __AVX2__
  return static_cast<unsigned>(_mm256_movemask_pd(reinterpret_cast<__m256d>(mask)));
#else
  return static_cast<unsigned>((mask[0] & 1) | (mask[1] & 2) | (mask[2] & 4) | (mask[3] & 8));
#endif
}

// Dekker 1971 / Veltkamp: the error of a product without FMA. Exact unless |a| or |b| > 2^996 or the error underflows.
template <typename T>
LOBER_INLINE T dekker_product_error(T a, T b, T product) {
  const T a_scaled = a * 134217729.0;  // 2^27 + 1
  const T b_scaled = b * 134217729.0;
  const T a_high = a_scaled - (a_scaled - a);
  const T b_high = b_scaled - (b_scaled - b);
  const T a_low = a - a_high;
  const T b_low = b - b_high;
  return ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
}

/// a * b - product, exactly, where product = fl(a * b).
LOBER_INLINE double product_error(double a, double b, double product) {
#ifdef __FMA__
  return __builtin_fma(a, b, -product);
#else
  return dekker_product_error(a, b, product);
#endif
}
LOBER_INLINE Lanes product_error(Lanes a, Lanes b, Lanes product) {
#ifdef __FMA__
  return _mm256_fmsub_pd(a, b, product);
#else
  return dekker_product_error(a, b, product);
#endif
}

}  // namespace lober::detail
