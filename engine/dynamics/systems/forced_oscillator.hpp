// The common parts of oscillators under a periodic force.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <span>
#include <vector>

#include "kernels/elementary.hpp"
#include "lober/dynamics/flow.hpp"
#include "lober/dynamics/systems.hpp"

namespace lober::detail {

/// Position and velocity under the force eps cos(omega t), with damping delta; Hamiltonian when delta is 0.
struct ForcedOscillator {
  static constexpr int dimension = 2;
  static constexpr std::size_t forcings = 1;
  static constexpr bool in_lanes = true;
  double eps, omega, delta;

  [[nodiscard]] double period() const { return 2 * std::numbers::pi / omega; }
  void forcing(double t, double* force) const { force[0] = eps * elementary::cos(omega * t); }
  [[nodiscard]] std::span<const ConjugatePair> pairs() const {
    static constexpr std::array<ConjugatePair, 1> pair{{{0, 1, 1}}};
    return std::span<const ConjugatePair>(pair).first(delta == 0 ? 1 : 0);
  }

  /// Symmetries under a force that is odd in x, on the section at `phase`.
  [[nodiscard]] std::vector<Symmetry> symmetries(double phase) const;

  /// The periodic orbit that a saddle of the unforced system becomes, u'' + delta u' = u + rest(u) + eps cos(omega t)
  /// with u measured from that saddle, where it meets the section at `phase`. By harmonic balance, which does not feel
  /// how fast orbits leave the saddle; the response to first order in eps where its iteration does not converge.
  [[nodiscard]] Point saddle_on_section(double phase, const std::function<double(double)>& rest) const;
};

}  // namespace lober::detail
