// A VectorField as a field of the integrators (maps/right_hand_sides.hpp).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "engine/dynamics/maps/flow_of.hpp"
#include "lober/dynamics/vector_field.hpp"

namespace lober::detail {

/// One of N coordinates; a periodic one is given the time as its forcing.
template <int N, bool periodic>
class OwnField {
 public:
  static constexpr int dimension = N;
  static constexpr std::size_t forcings = periodic ? 1 : 0;
  static constexpr bool in_lanes = false;

  explicit OwnField(std::shared_ptr<const VectorField> field)
      : field_(std::move(field)), unit_(unit_within(field_->extent())) {}

  [[nodiscard]] double period() const { return periodic ? field_->period() : 0; }
  void forcing(double t, double* force) const {
    if constexpr (periodic) force[0] = t;
  }
  [[nodiscard]] std::span<const ConjugatePair> pairs() const { return field_->conjugate_pairs(); }

  void velocity(const double* x, double* dxdt, const double* force) const {
    const double t = time(force);
    field_->velocities(1, x, &t, dxdt);
  }
  /// As Flow::velocities, by calls for some thousand points.
  void velocities(std::span<const FlowState> states, std::span<const double> times, std::span<FlowState> found) const {
    constexpr std::size_t max_points = 8192;
    std::vector<double> from, to;
    for (std::size_t begin = 0; begin < states.size(); begin += max_points) {
      const std::size_t count = std::min(max_points, states.size() - begin);
      from.resize(N * count);
      to.resize(N * count);
      for (std::size_t k = 0; k < count; ++k) {
        for (std::size_t i = 0; i < N; ++i) from[i * count + k] = states[begin + k][i];
      }
      field_->velocities(count, from.data(), times.data() + begin, to.data());
      for (std::size_t k = 0; k < count; ++k) {
        found[begin + k] = {};
        for (std::size_t i = 0; i < N; ++i) found[begin + k][i] = to[i * count + k];
      }
    }
  }
  /// The velocities at several points.
  template <int elements, InstructionSet isa>
  void velocity(const Wide<elements, isa>* x, Wide<elements, isa>* dxdt, const Wide<elements, isa>* force) const {
    double from[N][elements], to[N][elements], t[elements] = {};
    for (int i = 0; i < N; ++i) store_number(from[i], x[i]);
    if constexpr (periodic) store_number(t, force[0]);
    field_->velocities(elements, from[0], t, to[0]);
    for (int i = 0; i < N; ++i) dxdt[i] = load_number<Wide<elements, isa>>(to[i]);
  }
  template <int M>
  void velocity(const Jet<M, double>* x, Jet<M, double>* dxdt, const double* force) const {
    std::array<double, N> at{}, speed{};
    std::array<double, static_cast<std::size_t>(N * N)> jacobian{};
    for (std::size_t i = 0; i < N; ++i) at[i] = x[i].value;
    const double t = time(force);
    field_->velocities(1, at.data(), &t, speed.data());
    field_->jacobians(1, at.data(), &t, jacobian.data());
    for (std::size_t i = 0; i < N; ++i) {
      dxdt[i] = Jet<M>(speed[i]);
      for (std::size_t j = 0; j < N; ++j) {
        for (int k = 0; k < M; ++k) dxdt[i].slope[k] += jacobian[i * N + j] * x[j].slope[k];
      }
    }
  }
  double hamiltonian(const double* x, const double* force) const {
    const double t = time(force);
    double h = std::numeric_limits<double>::quiet_NaN();
    field_->hamiltonians(1, x, &t, &h);
    return h;
  }

  /// Steps of trajectories: eight at a time where that many velocities are computed together, however many are wanted,
  /// so that each has the same bits in any company.
  static void steps(const AlongFlow<OwnField>& rhs, StepBlock<N>& block, std::size_t count) {
    if (rhs.field.field_->batch() < block_lanes) {
      steps_one_by_one(rhs, block, count);
    } else {
      extrapolation_step<Wide<block_lanes, InstructionSet::baseline>>(rhs, block, 0);
    }
  }

  // For wide steps (integration/wide_steps.hpp).

  [[nodiscard]] const VectorField& many() const { return *field_; }
  /// Trajectories that are followed at a time; 0: as many as a block of steps holds.
  [[nodiscard]] std::size_t wide_lanes() const {
    return field_->batch() >= 8 * block_lanes ? std::max(block_lanes, field_->batch() / step_columns) : 0;
  }
  /// Whether derivatives are those of differences: a step of small errors would take their noise for errors.
  [[nodiscard]] bool has_rough_derivatives() const { return !field_->has_jacobian(); }
  [[nodiscard]] double unit() const { return unit_; }
  /// Tenths of work (PlanarMap::work) for an evaluation.
  [[nodiscard]] std::uint64_t tenths() const { return field_->batch() < block_lanes ? 10 : 1; }

 private:
  static double time(const double* force) {
    if constexpr (!periodic) return 0;
    return force[0];
  }

  std::shared_ptr<const VectorField> field_;
  double unit_;
};

}  // namespace lober::detail
