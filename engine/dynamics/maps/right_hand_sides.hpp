// The right-hand sides integrated along a trajectory: the flow alone, with tangent vectors, or with an action.
//
// A Field is a value type:
//   static constexpr int dimension;
//   static constexpr std::size_t forcings;         how many numbers it depends on by time alone
//   static constexpr bool in_lanes;                whether velocity takes any kind of number
//   double period() const;                         0 for autonomous fields, which have no forcings
//   void forcing(double t, double* force) const;   computes them
//   template <typename T, typename V> void velocity(const T* x, T* dxdt, const V* force) const;
//                                                  T = V or Jet<M, V>; V = double or Wide. LOBER_INLINE if in_lanes
//   std::span<const ConjugatePair> pairs() const;                    empty when not Hamiltonian
//   double hamiltonian(const double* x, const double* force) const;  called only when pairs() is not empty
#pragma once

#include <cstddef>

#include "engine/dynamics/maps/jet.hpp"
#include "kernels/inline.hpp"
#include "lober/dynamics/flow.hpp"

namespace lober::detail {

/// State: x.
template <typename Field>
struct AlongFlow {
  static constexpr int size = Field::dimension;
  static constexpr std::size_t forcings = Field::forcings;
  static constexpr bool in_lanes = Field::in_lanes;
  const Field& field;
  template <typename V>
  LOBER_INLINE void operator()(const V* x, V* dxdt, const V* force) const {
    field.velocity(x, dxdt, force);
  }
  /// Field::steps, if there is one (lane_steps.hpp).
  static auto own_steps() requires requires { &Field::steps; }
  { return &Field::steps; }
};

/// State: x, then M tangent vectors; v' = (d velocity / dx) v.
template <typename Field, int M>
struct WithTangents {
  static constexpr int n = Field::dimension;
  static constexpr int size = n * (1 + M);
  static constexpr std::size_t forcings = Field::forcings;
  static constexpr bool in_lanes = Field::in_lanes && M == 2;
  const Field& field;
  template <typename V>
  LOBER_INLINE void operator()(const V* x, V* dxdt, const V* force) const {
    Jet<M, V> point[n], speed[n];
    for (int i = 0; i < n; ++i) {
      point[i].value = x[i];
      for (int k = 0; k < M; ++k) point[i].slope[k] = x[n * (1 + k) + i];
    }
    field.velocity(point, speed, force);
    for (int i = 0; i < n; ++i) {
      dxdt[i] = speed[i].value;
      for (int k = 0; k < M; ++k) dxdt[n * (1 + k) + i] = speed[i].slope[k];
    }
  }
};

/// State: x, then the integral of p dq, less that of `with_energy` * H dt.
template <typename Field>
struct WithAction {
  static constexpr int n = Field::dimension;
  static constexpr int size = n + 1;
  static constexpr std::size_t forcings = Field::forcings;
  static constexpr bool in_lanes = false;
  const Field& field;
  double with_energy;
  void operator()(const double* x, double* dxdt, const double* force) const {
    field.velocity(x, dxdt, force);
    double sum = 0;
    for (const ConjugatePair& pair : field.pairs()) sum += pair.factor * x[pair.p] * dxdt[pair.q];
    dxdt[n] = with_energy != 0 ? sum - with_energy * field.hamiltonian(x, force) : sum;
  }
};

}  // namespace lober::detail
