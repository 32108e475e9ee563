// The velocity field of the flow of Arnold, Beltrami and Childress.
#pragma once

#include <cstddef>
#include <span>

#include "kernels/trigonometric.hpp"
#include "lober/dynamics/flow.hpp"

namespace lober::detail {

/// x' = A sin z + C cos y, y' = B sin x + A cos z, z' = C sin y + B cos x; the angles are lifted.
struct Abc {
  static constexpr int dimension = 3;
  static constexpr std::size_t forcings = 0;
  static constexpr bool in_lanes = true;
  double a, b, c;

  [[nodiscard]] static double period() { return 0; }
  [[nodiscard]] static std::span<const ConjugatePair> pairs() { return {}; }
  static void forcing(double /*t*/, double* /*force*/) {}
  template <typename T, typename V>
  LOBER_INLINE void velocity(const T* x, T* dxdt, const V* /*force*/) const {
    dxdt[0] = a * sine(x[2]) + c * cosine(x[1]);
    dxdt[1] = b * sine(x[0]) + a * cosine(x[2]);
    dxdt[2] = c * sine(x[1]) + b * cosine(x[0]);
  }
  static double hamiltonian(const double* /*x*/, const double* /*force*/) { return 0; }
};

}  // namespace lober::detail
