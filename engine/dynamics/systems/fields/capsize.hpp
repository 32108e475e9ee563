// The velocity field of roll and pitch.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "kernels/trigonometric.hpp"
#include "lober/dynamics/flow.hpp"

namespace lober::detail {

/// State (x, y, vx, vy): x'' = -x + 2 x y, y'' = -R^2 y + R^2 x^2 / 2, with the energy
/// vx^2 / 2 + vy^2 / R^2 + x^2 / 2 + y^2 - x^2 y. Momenta are vx and (2 / R^2) vy.
class Capsize {
 public:
  static constexpr int dimension = 4;
  static constexpr std::size_t forcings = 0;
  static constexpr bool in_lanes = true;
  explicit Capsize(double r) : r2_(r * r), pairs_{{{0, 2, 1}, {1, 3, 2 / (r * r)}}} {}

  [[nodiscard]] static double period() { return 0; }
  [[nodiscard]] std::span<const ConjugatePair> pairs() const { return pairs_; }
  static void forcing(double /*t*/, double* /*force*/) {}
  template <typename T, typename V>
  LOBER_INLINE void velocity(const T* x, T* dxdt, const V* /*force*/) const {
    dxdt[0] = x[2];
    dxdt[1] = x[3];
    dxdt[2] = x[0] * (2.0 * x[1] - 1.0);
    dxdt[3] = r2_ * (0.5 * (x[0] * x[0]) - x[1]);
  }
  double hamiltonian(const double* x, const double* /*force*/) const {
    return 0.5 * (x[2] * x[2] + x[0] * x[0]) + x[3] * x[3] / r2_ + x[1] * (x[1] - x[0] * x[0]);
  }

 private:
  double r2_;
  std::array<ConjugatePair, 2> pairs_;
};

}  // namespace lober::detail
