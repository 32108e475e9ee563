// The velocity field of the double gyre.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "kernels/elementary.hpp"
#include "kernels/trigonometric.hpp"
#include "lober/dynamics/flow.hpp"

namespace lober::detail {

/// x' = -pi A sin(pi f) cos(pi y), y' = pi A cos(pi f) sin(pi y) df/dx, with f = a x^2 + (1 - 2 a) x and
/// a = eps sin(omega t); the stream function A sin(pi f) sin(pi y) is minus the Hamiltonian.
struct DoubleGyre {
  static constexpr int dimension = 2;
  static constexpr std::size_t forcings = 1;  // a
  static constexpr bool in_lanes = true;
  double amplitude, eps, omega;

  [[nodiscard]] double period() const { return 2 * std::numbers::pi / omega; }
  [[nodiscard]] std::span<const ConjugatePair> pairs() const {
    static constexpr std::array<ConjugatePair, 1> pair{{{0, 1, 1}}};
    return pair;
  }
  void forcing(double t, double* force) const { force[0] = eps * elementary::sin(omega * t); }
  template <typename T, typename V>
  LOBER_INLINE void velocity(const T* x, T* dxdt, const V* force) const {
    constexpr double pi = std::numbers::pi;
    const V a = force[0], b = 1.0 - 2.0 * a;
    const T f = pi * (x[0] * (x[0] * a + b));
    const T y = pi * x[1];
    dxdt[0] = -pi * amplitude * (sine(f) * cosine(y));
    dxdt[1] = pi * amplitude * (cosine(f) * sine(y)) * (x[0] * (2.0 * a) + b);
  }
  double hamiltonian(const double* x, const double* force) const {
    constexpr double pi = std::numbers::pi;
    const double a = force[0];
    return -amplitude * elementary::sin(pi * x[0] * (a * x[0] + (1 - 2 * a))) * elementary::sin(pi * x[1]);
  }
};

}  // namespace lober::detail
