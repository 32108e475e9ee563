// Error-free transforms and double-double arithmetic: an unevaluated sum hi + lo of two doubles, about 106 bits.
//
// All of it is written once for `double` and for vectors of doubles (kernels/eight.hpp), with the same sequence of
// roundings in each lane, so that scalar and vector code give the same bits.
//
// Error bounds, u = 2^-53, no overflow or underflow (Dekker 1971, Knuth TAOCP 4.2.2; Joldes, Muller & Popescu 2017):
//   two_sum, two_diff, two_product   exact
//   dd + dd                          relative 3 u^2 + 13 u^3
//   dd * dd                          relative 5 u^2
//   dd / dd                          relative 10 u^2
#pragma once

#include "kernels/eight.hpp"

namespace lober::detail {

/// hi + lo with |lo| <= ulp(hi) / 2 after every operation below.
template <typename T>
struct BasicDD {
  T hi{};
  T lo{};
  using LeftUnfilled = void;  ///< in arrays (lober/base/buffer.hpp)
};
using DD = BasicDD<double>;

/// a + b exactly (Knuth): 6 operations, any order of magnitudes.
template <typename T>
LOBER_INLINE BasicDD<T> two_sum(T a, T b) {
  const T sum = a + b;
  const T b_part = sum - a;
  const T a_part = sum - b_part;
  return {sum, (a - a_part) + (b - b_part)};
}

/// a - b exactly.
template <typename T>
LOBER_INLINE BasicDD<T> two_diff(T a, T b) {
  const T difference = a - b;
  const T b_part = difference - a;
  const T a_part = difference - b_part;
  return {difference, (a - a_part) - (b + b_part)};
}

/// a + b exactly when |a| >= |b| or a == 0 (Dekker): 3 operations.
template <typename T>
LOBER_INLINE BasicDD<T> fast_two_sum(T a, T b) {
  const T sum = a + b;
  return {sum, b - (sum - a)};
}

/// a * b exactly.
template <typename T>
LOBER_INLINE BasicDD<T> two_product(T a, T b) {
  const T product = a * b;
  return {product, product_error(a, b, product)};
}

template <typename T>
LOBER_INLINE BasicDD<T> operator-(BasicDD<T> a) {
  return {-a.hi, -a.lo};
}

template <typename T>
LOBER_INLINE BasicDD<T> operator+(BasicDD<T> a, BasicDD<T> b) {
  const BasicDD<T> high = two_sum(a.hi, b.hi);
  const BasicDD<T> low = two_sum(a.lo, b.lo);
  const BasicDD<T> first = fast_two_sum(high.hi, high.lo + low.hi);
  return fast_two_sum(first.hi, first.lo + low.lo);
}

template <typename T>
LOBER_INLINE BasicDD<T> operator-(BasicDD<T> a, BasicDD<T> b) {
  return a + (-b);
}

template <typename T>
LOBER_INLINE BasicDD<T> operator*(BasicDD<T> a, BasicDD<T> b) {
  const BasicDD<T> product = two_product(a.hi, b.hi);
  return fast_two_sum(product.hi, product.lo + (a.hi * b.lo + a.lo * b.hi));
}

template <typename T>
LOBER_INLINE BasicDD<T> operator/(BasicDD<T> a, BasicDD<T> b) {
  const T first = a.hi / b.hi;
  const BasicDD<T> product = two_product(first, b.hi);
  // a - first * b: a.hi - product.hi is exact, because the quotient is right to half an ulp.
  const T rest = (((a.hi - product.hi) - product.lo) + a.lo) - first * b.lo;
  return fast_two_sum(first, rest / b.hi);
}

LOBER_INLINE DD& operator+=(DD& a, DD b) {
  return a = a + b;
}
LOBER_INLINE DD& operator-=(DD& a, DD b) {
  return a = a - b;
}

/// The determinant |u v| = u.x v.y - u.y v.x of two double-double vectors; error 12 u^2 (|u.x v.y| + |u.y v.x|).
template <typename T>
LOBER_INLINE BasicDD<T> cross(BasicDD<T> ux, BasicDD<T> uy, BasicDD<T> vx, BasicDD<T> vy) {
  return ux * vy - uy * vx;
}

}  // namespace lober::detail
