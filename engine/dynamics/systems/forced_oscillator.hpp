// What oscillators under a periodic force have in common.
#pragma once

#include <array>
#include <complex>
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

  /// Where the periodic orbit that a saddle of the unforced system becomes lies on the section at `phase`, from there
  /// on, to first order in eps: the response of u'' + delta u' - u = eps cos(omega t). Both systems have saddles with
  /// this linear part.
  [[nodiscard]] Point saddle_response(double phase) const {
    const std::complex<double> i{0, 1};
    const std::complex<double> amplitude = eps / (-1 - omega * omega + i * delta * omega);
    const std::complex<double> u = amplitude * std::exp(i * (2 * std::numbers::pi * phase));
    return {u.real(), (i * omega * u).real()};
  }
};

}  // namespace lober
