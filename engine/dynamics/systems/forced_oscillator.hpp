// What oscillators under a periodic force have in common.
#pragma once

#include <array>
#include <numbers>
#include <span>

#include "engine/dynamics/flow.hpp"

namespace lober {

/// Position and velocity under the force eps cos(omega t), with damping delta; Hamiltonian when delta is 0.
struct ForcedOscillator {
  static constexpr int dimension = 2;
  double eps, omega, delta;

  [[nodiscard]] double period() const { return 2 * std::numbers::pi / omega; }
  [[nodiscard]] std::span<const ConjugatePair> pairs() const {
    static constexpr std::array<ConjugatePair, 1> pair{{{0, 1, 1}}};
    return std::span<const ConjugatePair>(pair).first(delta == 0 ? 1 : 0);
  }
};

}  // namespace lober
