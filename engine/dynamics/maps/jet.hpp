// Numbers that carry their derivatives in M directions along. A vector field that is written once, for any kind of
// number, yields its Jacobian and its variational equations in this way.
#pragma once

#include "kernels/trigonometric.hpp"

namespace lober::detail {

/// V: double or Wide.
template <int M, typename V = double>
struct Jet {
  V value;
  V slope[M];

  Jet() = default;
  LOBER_INLINE Jet(V constant) : value(constant) {  // NOLINT: a constant is a number without slope
    for (int k = 0; k < M; ++k) slope[k] = V(0.0);
  }

  /// The jet of g(*this), from g and its derivative.
  [[nodiscard]] LOBER_INLINE Jet through(V image, V derivative) const {
    Jet result;
    result.value = image;
    for (int k = 0; k < M; ++k) result.slope[k] = derivative * slope[k];
    return result;
  }

  LOBER_INLINE friend Jet operator-(const Jet& a) {
    Jet result;
    result.value = -a.value;
    for (int k = 0; k < M; ++k) result.slope[k] = -a.slope[k];
    return result;
  }
  LOBER_INLINE friend Jet operator+(Jet a, const Jet& b) {
    a.value = a.value + b.value;
    for (int k = 0; k < M; ++k) a.slope[k] = a.slope[k] + b.slope[k];
    return a;
  }
  LOBER_INLINE friend Jet operator-(Jet a, const Jet& b) {
    a.value = a.value - b.value;
    for (int k = 0; k < M; ++k) a.slope[k] = a.slope[k] - b.slope[k];
    return a;
  }
  LOBER_INLINE friend Jet operator*(const Jet& a, const Jet& b) {
    Jet result;
    result.value = a.value * b.value;
    for (int k = 0; k < M; ++k) result.slope[k] = a.slope[k] * b.value + a.value * b.slope[k];
    return result;
  }
  LOBER_INLINE friend Jet operator/(const Jet& a, const Jet& b) {
    const V inverse = V(1.0) / b.value;
    Jet result;
    result.value = a.value / b.value;
    for (int k = 0; k < M; ++k) result.slope[k] = (a.slope[k] - result.value * b.slope[k]) * inverse;
    return result;
  }
  // Operators with constants, so that no products with slopes of zero are made. A double becomes a V.
  LOBER_INLINE friend Jet operator+(Jet a, V b) {
    a.value = a.value + b;
    return a;
  }
  LOBER_INLINE friend Jet operator+(V a, const Jet& b) { return b + a; }
  LOBER_INLINE friend Jet operator-(Jet a, V b) {
    a.value = a.value - b;
    return a;
  }
  LOBER_INLINE friend Jet operator-(V a, const Jet& b) {
    Jet result = -b;
    result.value = a - b.value;
    return result;
  }
  LOBER_INLINE friend Jet operator*(const Jet& a, V b) { return a.through(a.value * b, b); }
  LOBER_INLINE friend Jet operator*(V a, const Jet& b) { return b * a; }
  LOBER_INLINE friend Jet operator/(V a, const Jet& b) {
    const V inverse = V(1.0) / b.value, quotient = a * inverse;
    return b.through(quotient, -quotient * inverse);
  }
  LOBER_INLINE friend Jet square_root(const Jet& a) {
    const V root = square_root(a.value);
    return a.through(root, V(0.5) / root);
  }
  LOBER_INLINE friend Jet sine(const Jet& a) { return a.through(sine(a.value), cosine(a.value)); }
  LOBER_INLINE friend Jet cosine(const Jet& a) { return a.through(cosine(a.value), -sine(a.value)); }
};

}  // namespace lober::detail
