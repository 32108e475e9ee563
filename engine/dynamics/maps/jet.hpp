// Numbers that carry their derivatives in M directions along. A vector field that is written once, for any kind of
// number, yields its Jacobian and its variational equations in this way.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace lober::detail {

template <int M>
struct Jet {
  double value = 0;
  std::array<double, M> slope{};

  Jet() = default;
  Jet(double constant) : value(constant) {}  // NOLINT: a constant is a number without slope

  /// The jet of g(*this), from g and its derivative.
  [[nodiscard]] Jet through(double image, double derivative) const {
    Jet result(image);
    for (std::size_t k = 0; k < M; ++k) result.slope[k] = derivative * slope[k];
    return result;
  }

  friend Jet operator-(const Jet& a) { return a.through(-a.value, -1); }
  friend Jet operator+(Jet a, const Jet& b) {
    a.value += b.value;
    for (std::size_t k = 0; k < M; ++k) a.slope[k] += b.slope[k];
    return a;
  }
  friend Jet operator-(Jet a, const Jet& b) {
    a.value -= b.value;
    for (std::size_t k = 0; k < M; ++k) a.slope[k] -= b.slope[k];
    return a;
  }
  friend Jet operator*(const Jet& a, const Jet& b) {
    Jet result(a.value * b.value);
    for (std::size_t k = 0; k < M; ++k) result.slope[k] = a.slope[k] * b.value + a.value * b.slope[k];
    return result;
  }
  friend Jet operator/(const Jet& a, const Jet& b) {
    Jet result(a.value / b.value);
    for (std::size_t k = 0; k < M; ++k) result.slope[k] = (a.slope[k] - result.value * b.slope[k]) / b.value;
    return result;
  }
  // With constants, so that no products with slopes of zero are made.
  friend Jet operator+(Jet a, double b) {
    a.value += b;
    return a;
  }
  friend Jet operator+(double a, const Jet& b) { return b + a; }
  friend Jet operator-(Jet a, double b) {
    a.value -= b;
    return a;
  }
  friend Jet operator-(double a, const Jet& b) { return b.through(a - b.value, -1); }
  friend Jet operator*(const Jet& a, double b) { return a.through(a.value * b, b); }
  friend Jet operator*(double a, const Jet& b) { return b * a; }
  friend Jet operator/(const Jet& a, double b) { return a * (1 / b); }
  friend Jet operator/(double a, const Jet& b) {
    const double quotient = a / b.value;
    return b.through(quotient, -quotient / b.value);
  }
  friend Jet sqrt(const Jet& a) {
    const double root = std::sqrt(a.value);
    return a.through(root, 0.5 / root);
  }
  friend Jet sin(const Jet& a) { return a.through(std::sin(a.value), std::cos(a.value)); }
  friend Jet cos(const Jet& a) { return a.through(std::cos(a.value), -std::sin(a.value)); }
};

}  // namespace lober::detail
