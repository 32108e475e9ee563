// What is integrated along a trajectory: the flow alone, with tangent vectors, or with an action.
//
// A Field is a value type:
//   static constexpr int dimension;
//   double period() const;                                        0 for autonomous fields
//   template <typename T> void velocity(const T* x, T* dxdt, double t) const;      T = double or Jet<M>
//   std::span<const ConjugatePair> pairs() const;                 empty when not Hamiltonian
//   double hamiltonian(const double* x, double t) const;          called only when pairs() is not empty
#pragma once

#include <array>
#include <cstddef>

#include "engine/dynamics/maps/jet.hpp"
#include "lober/flow.hpp"

namespace lober::detail {

/// State: x.
template <typename Field>
struct AlongFlow {
  static constexpr std::size_t size = Field::dimension;
  const Field& field;
  void operator()(const std::array<double, size>& x, std::array<double, size>& dxdt, double t) const {
    field.velocity(x.data(), dxdt.data(), t);
  }
};

/// State: x, then M tangent vectors; v' = (d velocity / dx) v.
template <typename Field, int M>
struct WithTangents {
  static constexpr std::size_t n = Field::dimension;
  static constexpr std::size_t size = n * (1 + M);
  const Field& field;
  void operator()(const std::array<double, size>& x, std::array<double, size>& dxdt, double t) const {
    std::array<Jet<M>, n> point, speed;
    for (std::size_t i = 0; i < n; ++i) {
      point[i].value = x[i];
      for (std::size_t k = 0; k < M; ++k) point[i].slope[k] = x[n * (1 + k) + i];
    }
    field.velocity(point.data(), speed.data(), t);
    for (std::size_t i = 0; i < n; ++i) {
      dxdt[i] = speed[i].value;
      for (std::size_t k = 0; k < M; ++k) dxdt[n * (1 + k) + i] = speed[i].slope[k];
    }
  }
};

/// State: x, then the integral of p dq, less that of `with_energy` * H dt.
template <typename Field>
struct WithAction {
  static constexpr bool ends_in_integral = true;
  static constexpr std::size_t n = Field::dimension;
  static constexpr std::size_t size = n + 1;
  const Field& field;
  double with_energy;
  void operator()(const std::array<double, size>& x, std::array<double, size>& dxdt, double t) const {
    field.velocity(x.data(), dxdt.data(), t);
    double sum = 0;
    for (const ConjugatePair& pair : field.pairs()) {
      sum += pair.factor * x[static_cast<std::size_t>(pair.p)] * dxdt[static_cast<std::size_t>(pair.q)];
    }
    dxdt[n] = with_energy != 0 ? sum - with_energy * field.hamiltonian(x.data(), t) : sum;
  }
};

}  // namespace lober::detail
