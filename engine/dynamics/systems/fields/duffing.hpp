// The velocity field of the forced Duffing oscillator.
#pragma once

#include <cmath>
#include <cstddef>

#include "engine/dynamics/systems/forced_oscillator.hpp"
#include "kernels/trigonometric.hpp"

namespace lober::detail {

/// x' = y, y' = x - x^3 - delta y + eps cos(omega t).
struct Duffing : ForcedOscillator {
  template <typename T, typename V>
  LOBER_INLINE void velocity(const T* x, T* dxdt, const V* force) const {
    dxdt[0] = x[1];
    dxdt[1] = x[0] - x[0] * x[0] * x[0] - delta * x[1] + force[0];
  }
  double hamiltonian(const double* x, const double* force) const {
    const double square = x[0] * x[0];
    return 0.5 * x[1] * x[1] - 0.5 * square + 0.25 * square * square - x[0] * force[0];
  }
};

}  // namespace lober::detail
