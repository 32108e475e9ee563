// The velocity field of the forced pendulum.
#pragma once

#include <cmath>
#include <cstddef>

#include "engine/dynamics/systems/forced_oscillator.hpp"
#include "kernels/elementary.hpp"
#include "kernels/trigonometric.hpp"

namespace lober::detail {

/// x' = y, y' = -sin x - delta y + eps cos(omega t); the angle x is lifted.
struct Pendulum : ForcedOscillator {
  template <typename T, typename V>
  LOBER_INLINE void velocity(const T* x, T* dxdt, const V* force) const {
    dxdt[0] = x[1];
    dxdt[1] = force[0] - sine(x[0]) - delta * x[1];
  }
  double hamiltonian(const double* x, const double* force) const {
    return 0.5 * x[1] * x[1] - elementary::cos(x[0]) - x[0] * force[0];
  }
};

}  // namespace lober::detail
