// The right-hand sides integrated along a trajectory: the flow alone, with tangent vectors, or with an action.
//
// A Field is a value type:
//   static constexpr int dimension;
//   static constexpr std::size_t forcings;         how many numbers it depends on by time alone
//   static constexpr bool in_lanes;                whether velocity takes any kind of number
//   double unit() const;                           PlanarMap::unit, where coordinates may have any size; those of the
//                                                  built-in fields, which leave it out, are of order one
//   double period() const;                         0 for autonomous fields, which have no forcings
//   void forcing(double t, double* force) const;   computes them
//   template <typename T, typename V> void velocity(const T* x, T* dxdt, const V* force) const;
//                                                  T = V or Jet<M, V>; V = double or Wide. LOBER_INLINE if in_lanes
//   std::span<const ConjugatePair> pairs() const;                    empty when not Hamiltonian
//   double hamiltonian(const double* x, const double* force) const;  called only when pairs() is not empty
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "engine/dynamics/maps/jet.hpp"
#include "kernels/inline.hpp"
#include "lober/dynamics/flow.hpp"
#include "lober/dynamics/vector_field.hpp"

namespace lober::detail {

/// A field that is computed for many points at a time, by the VectorField many(), wide_lanes() trajectories side by
/// side (integration/wide_steps.hpp).
template <typename Field>
concept is_many = requires(const Field& field) {
  field.many().velocities(0, nullptr, nullptr, nullptr);
};

/// Whether errors are judged by the size of each coordinate (integration/component_scales.hpp).
template <typename Field>
constexpr bool has_own_units = requires(const Field& field) {
  field.unit();
};
/// PlanarMap::unit of the maps of a field.
template <typename Field>
double unit_of(const Field& field) {
  if constexpr (has_own_units<Field>) return field.unit();
  return 1;
}

/// State: x.
template <typename Field>
struct AlongFlow {
  static constexpr int size = Field::dimension;
  static constexpr std::size_t forcings = Field::forcings;
  static constexpr bool in_lanes = Field::in_lanes;
  static constexpr bool own_units = has_own_units<Field>;
  const Field& field;
  template <typename V>
  LOBER_INLINE void operator()(const V* x, V* dxdt, const V* force) const {
    field.velocity(x, dxdt, force);
  }
  void many(std::size_t count, const double* x, const double* t, double* dxdt) const requires is_many<Field> {
    field.many().velocities(count, x, t, dxdt);
  }
  [[nodiscard]] std::size_t wide_lanes() const requires is_many<Field> { return field.wide_lanes(); }
  /// Field::steps, if there is one (lane_steps.hpp).
  static auto own_steps() requires requires { &Field::steps; }
  { return &Field::steps; }
};

/// Whether the derivatives of a field are those of differences, whose noise steps of small errors would take for
/// theirs.
template <typename Field>
bool has_rough_derivatives(const Field& field) {
  if constexpr (requires { field.has_rough_derivatives(); }) return field.has_rough_derivatives();
  return false;
}
/// Options for tangent vectors of such a field; points are integrated by themselves.
inline IntegrationOptions with_rough_derivatives(IntegrationOptions options) {
  options.tolerance = std::max(options.tolerance, 1e-9);
  return options;
}

/// The velocities of points and their derivatives along tangent vectors, by differences, with one call of the field for
/// some thousand of them. x: coordinates, then those of each vector, as wide steps have them; dxdt likewise.
void velocities_with_tangents(const VectorField& field, std::size_t tangents, std::size_t count, const double* x,
                              const double* t, double* dxdt);

/// State: x, then M tangent vectors; v' = (d velocity / dx) v.
template <typename Field, int M>
struct WithTangents {
  static constexpr int n = Field::dimension;
  static constexpr int size = n * (1 + M);
  static constexpr std::size_t forcings = Field::forcings;
  static constexpr bool in_lanes = Field::in_lanes && M == 2;
  static constexpr bool own_units = has_own_units<Field>;
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
  void many(std::size_t count, const double* x, const double* t, double* dxdt) const requires is_many<Field> {
    if (lober::detail::has_rough_derivatives(field)) {
      velocities_with_tangents(field.many(), M, count, x, t, dxdt);
      return;
    }
    field.many().velocities(count, x, t, dxdt);
    std::vector<double> jacobian(static_cast<std::size_t>(n * n) * count);
    field.many().jacobians(count, x, t, jacobian.data());
    for (std::size_t m = 1; m <= M; ++m) {
      for (std::size_t i = 0; i < n; ++i) {
        double* const to = dxdt + (n * m + i) * count;
        std::fill_n(to, count, 0.0);
        for (std::size_t j = 0; j < n; ++j) {
          const double* const slope = jacobian.data() + (i * n + j) * count;
          const double* const tangent = x + (n * m + j) * count;
          for (std::size_t k = 0; k < count; ++k) to[k] += slope[k] * tangent[k];
        }
      }
    }
  }
  [[nodiscard]] std::size_t wide_lanes() const requires is_many<Field> { return field.wide_lanes(); }
};

/// State: x, then the integral of p dq, less that of `with_energy` * H dt.
template <typename Field>
struct WithAction {
  static constexpr int n = Field::dimension;
  static constexpr int size = n + 1;
  static constexpr std::size_t forcings = Field::forcings;
  static constexpr bool in_lanes = false;
  static constexpr bool own_units = has_own_units<Field>;
  const Field& field;
  double with_energy;
  void operator()(const double* x, double* dxdt, const double* force) const {
    field.velocity(x, dxdt, force);
    double sum = 0;
    for (const ConjugatePair& pair : field.pairs()) sum += pair.factor * x[pair.p] * dxdt[pair.q];
    dxdt[n] = with_energy != 0 ? sum - with_energy * field.hamiltonian(x, force) : sum;
  }
  void many(std::size_t count, const double* x, const double* t, double* dxdt) const requires is_many<Field> {
    field.many().velocities(count, x, t, dxdt);
    double* const along = dxdt + n * count;
    std::fill_n(along, count, 0.0);
    for (const ConjugatePair& pair : field.pairs()) {
      const auto q = static_cast<std::size_t>(pair.q), p = static_cast<std::size_t>(pair.p);
      for (std::size_t k = 0; k < count; ++k) along[k] += pair.factor * x[p * count + k] * dxdt[q * count + k];
    }
    if (with_energy == 0) return;
    std::vector<double> energy(count);
    field.many().hamiltonians(count, x, t, energy.data());
    for (std::size_t k = 0; k < count; ++k) along[k] -= with_energy * energy[k];
  }
  [[nodiscard]] std::size_t wide_lanes() const requires is_many<Field> { return field.wide_lanes(); }
};

}  // namespace lober::detail
