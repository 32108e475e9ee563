// A Flow made of a field (right_hand_sides.hpp), with the field compiled into the integrators.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>

#include "engine/dynamics/maps/crossing.hpp"
#include "engine/dynamics/maps/section_map.hpp"
#include "engine/dynamics/maps/stroboscopic_map.hpp"
#include "lober/error.hpp"
#include "lober/flow.hpp"

namespace lober::detail {

template <typename Field>
class FlowOf final : public Flow {
 public:
  explicit FlowOf(Field field) : field_(std::move(field)) {}

  [[nodiscard]] int dimension() const override { return Field::dimension; }
  [[nodiscard]] double period() const override { return field_.period(); }
  [[nodiscard]] FlowState velocity(const FlowState& state, double time) const override {
    FlowState result{};
    field_.velocity(state.data(), result.data(), time);
    return result;
  }
  [[nodiscard]] FlowMatrix jacobian(const FlowState& state, double time) const override {
    std::array<double, n*(1 + n)> x{}, dxdt{};
    copy_with_unit_tangents(state, x);
    WithTangents<Field, static_cast<int>(n)>{field_}(x, dxdt, time);
    return tangents(dxdt);
  }
  [[nodiscard]] std::span<const ConjugatePair> conjugate_pairs() const override { return field_.pairs(); }
  [[nodiscard]] double hamiltonian(const FlowState& state, double time) const override {
    require_hamiltonian();
    return field_.hamiltonian(state.data(), time);
  }

  void integrate(std::span<FlowState> states, double from, double to,
                 const IntegrationOptions& options) const override {
    const AlongFlow<Field> rhs{field_};
    Integrator<n, AlongFlow<Field>> integrator(rhs, options, n);
    for (FlowState& state : states) {
      integrator.start(narrow<n>(state), from, to < from ? -1 : 1);
      state = integrator.advance(to) ? widen(integrator.x) : lost_state();
    }
  }

  FlowState integrate_with_derivative(const FlowState& state, double from, double to, FlowMatrix& derivative,
                                      const IntegrationOptions& options) const override {
    using Rhs = WithTangents<Field, static_cast<int>(n)>;
    const Rhs rhs{field_};
    Integrator<Rhs::size, Rhs> integrator(rhs, options, n);
    std::array<double, Rhs::size> start{};
    copy_with_unit_tangents(state, start);
    integrator.start(start, from, to < from ? -1 : 1);
    if (!integrator.advance(to)) return lost_state();
    derivative = tangents(integrator.x);
    return widen(integrator.x);
  }

  FlowState integrate_with_action(const FlowState& state, double from, double to, double& action,
                                  const IntegrationOptions& options) const override {
    require_hamiltonian();
    const WithAction<Field> rhs{field_, 0};
    Integrator<n + 1, WithAction<Field>> integrator(rhs, options, n);
    std::array<double, n + 1> start = narrow<n + 1>(state);
    start[n] = 0;
    integrator.start(start, from, to < from ? -1 : 1);
    if (!integrator.advance(to)) return lost_state();
    action = integrator.x[n];
    return widen(integrator.x);
  }

  void to_section(std::span<FlowState> states, std::span<double> times, const Section& section, int crossings,
                  const IntegrationOptions& options) const override {
    if (period() != 0) throw UsageError("crossings of a section are found for autonomous flows only");
    if (section.coordinate < 0 || section.coordinate >= Field::dimension) {
      throw UsageError("the section's coordinate does not exist");
    }
    const AlongFlow<Field> rhs{field_};
    Integrator<n, AlongFlow<Field>> integrator(rhs, options, n);
    CrossingFinder finder(integrator, rhs, section, options.max_time);
    const int forward = crossings < 0 ? -1 : 1;
    for (std::size_t i = 0; i < states.size(); ++i) {
      double time = 0;
      for (int k = 0; k != crossings; k += forward) {
        if (!finder.next(narrow<n>(states[i]), forward)) {
          states[i] = lost_state();
          time = std::numeric_limits<double>::quiet_NaN();
          break;
        }
        states[i] = widen(finder.state);
        time += finder.time;
      }
      if (!times.empty()) times[i] = time;
    }
  }

  [[nodiscard]] std::unique_ptr<PlanarMap> stroboscopic_map(double phase,
                                                            const IntegrationOptions& options) const override {
    if constexpr (n == 2) {
      if (period() > 0) return std::make_unique<StroboscopicMap<Field>>(field_, phase, options);
    }
    throw UsageError("a stroboscopic map needs a time-periodic flow of two dimensions");
  }

  [[nodiscard]] std::unique_ptr<PlanarMap> section_map(const Section& section, double energy,
                                                       const IntegrationOptions& options) const override {
    if constexpr (n == 3 || n == 4) return std::make_unique<SectionMap<Field>>(field_, section, energy, options);
    throw UsageError("a return map needs a flow of three dimensions, or of four with a Hamiltonian");
  }

  [[nodiscard]] FlowState on_section(const Section& section, double energy, Point point) const override {
    if constexpr (n == 3 || n == 4) {
      typename SectionChart<Field>::State x;
      return SectionChart<Field>(field_, section, energy).lift(point, x) ? widen(x) : lost_state();
    }
    throw UsageError("a section needs a flow of three dimensions, or of four with a Hamiltonian");
  }

 private:
  static constexpr std::size_t n = Field::dimension;
  static_assert(Field::dimension >= 1 && Field::dimension <= max_flow_dimension);

  void require_hamiltonian() const {
    if (field_.pairs().empty()) throw UsageError("the flow is not Hamiltonian");
  }

  template <std::size_t N>
  static std::array<double, N> narrow(const FlowState& state) {
    std::array<double, N> result{};
    std::copy_n(state.begin(), n, result.begin());
    return result;
  }
  template <std::size_t N>
  static FlowState widen(const std::array<double, N>& x) {
    FlowState result{};
    std::copy_n(x.begin(), n, result.begin());
    return result;
  }
  static FlowState lost_state() {
    FlowState result;
    result.fill(std::numeric_limits<double>::quiet_NaN());
    return result;
  }
  static void copy_with_unit_tangents(const FlowState& state, std::array<double, n*(1 + n)>& x) {
    std::copy_n(state.begin(), n, x.begin());
    for (std::size_t k = 0; k < n; ++k) x[n * (1 + k) + k] = 1;
  }
  static FlowMatrix tangents(const std::array<double, n*(1 + n)>& x) {
    FlowMatrix result{};
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t i = 0; i < n; ++i) result[i][k] = x[n * (1 + k) + i];
    }
    return result;
  }

  Field field_;
};

}  // namespace lober::detail
