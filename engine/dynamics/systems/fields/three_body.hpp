// The velocity field of the planar circular restricted three-body problem.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "kernels/trigonometric.hpp"
#include "lober/dynamics/flow.hpp"

namespace lober::detail {

/// State (x, y, px, py) in the rotating frame, 1 - mu at (-mu, 0) and mu at (1 - mu, 0):
/// H = (px^2 + py^2) / 2 + px y - py x - (1 - mu) / r1 - mu / r2 - mu (1 - mu) / 2.
struct ThreeBody {
  static constexpr int dimension = 4;
  static constexpr std::size_t forcings = 0;
  static constexpr bool in_lanes = true;
  double mu;

  [[nodiscard]] static double period() { return 0; }
  [[nodiscard]] static std::span<const ConjugatePair> pairs() {
    static constexpr std::array<ConjugatePair, 2> pairs{{{0, 2, 1}, {1, 3, 1}}};
    return pairs;
  }
  static void forcing(double /*t*/, double* /*force*/) {}
  template <typename T, typename V>
  LOBER_INLINE void velocity(const T* x, T* dxdt, const V* /*force*/) const {
    const T a = x[0] + mu;
    const T b = x[0] - (1 - mu);
    const T square = x[1] * x[1];
    const T r1 = a * a + square;
    const T r2 = b * b + square;
    const T pull1 = (1 - mu) / (r1 * square_root(r1));
    const T pull2 = mu / (r2 * square_root(r2));
    dxdt[0] = x[2] + x[1];
    dxdt[1] = x[3] - x[0];
    dxdt[2] = x[3] - a * pull1 - b * pull2;
    dxdt[3] = -x[2] - x[1] * (pull1 + pull2);
  }
  double hamiltonian(const double* x, const double* /*force*/) const {
    return 0.5 * (x[2] * x[2] + x[3] * x[3]) + x[2] * x[1] - x[3] * x[0] - (1 - mu) / std::hypot(x[0] + mu, x[1]) -
           mu / std::hypot(x[0] - (1 - mu), x[1]) - 0.5 * mu * (1 - mu);
  }
};

}  // namespace lober::detail
