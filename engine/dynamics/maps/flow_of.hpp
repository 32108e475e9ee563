// A Flow made of a field (right_hand_sides.hpp), with the field compiled into the integrators.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <memory>
#include <span>
#include <utility>

#include "engine/dynamics/integration/section_lanes.hpp"
#include "engine/dynamics/integration/span_lanes.hpp"
#include "engine/dynamics/integration/wide_steps.hpp"
#include "engine/dynamics/maps/section_map.hpp"
#include "engine/dynamics/maps/stroboscopic_map.hpp"
#include "lober/base/error.hpp"
#include "lober/dynamics/flow.hpp"

namespace lober::detail {

template <typename Field>
class FlowOf final : public Flow {
 public:
  explicit FlowOf(Field field) : field_(std::move(field)) {}

  [[nodiscard]] int dimension() const override { return Field::dimension; }
  [[nodiscard]] double period() const override { return field_.period(); }
  [[nodiscard]] FlowState velocity(const FlowState& state, double time) const override {
    FlowState result{};
    field_.velocity(state.data(), result.data(), Forcing(field_, time).numbers);
    return result;
  }
  void velocities(std::span<const FlowState> states, std::span<const double> times,
                  std::span<FlowState> found) const override {
    if constexpr (requires { field_.many(); }) {
      field_.velocities(states, times, found);
    } else {
      Flow::velocities(states, times, found);
    }
  }
  [[nodiscard]] FlowMatrix jacobian(const FlowState& state, double time) const override {
    double x[n * (1 + n)], dxdt[n * (1 + n)];
    copy_with_unit_tangents(state, x);
    WithTangents<Field, static_cast<int>(n)>{field_}(x, dxdt, Forcing(field_, time).numbers);
    return tangents(dxdt);
  }
  [[nodiscard]] std::span<const ConjugatePair> conjugate_pairs() const override { return field_.pairs(); }
  [[nodiscard]] double hamiltonian(const FlowState& state, double time) const override {
    require_hamiltonian();
    return field_.hamiltonian(state.data(), Forcing(field_, time).numbers);
  }

  void integrate(std::span<FlowState> states, double from, double to,
                 const IntegrationOptions& options) const override {
    struct Queue {
      std::span<FlowState> states;
      std::size_t begun = 0;

      bool next(std::size_t& item, double* state) {
        if (begun == states.size()) return false;
        item = begun++;
        std::copy_n(states[item].begin(), n, state);
        return true;
      }
      void arrived(std::size_t item, const double* state) { states[item] = widened(state); }
      void lost(std::size_t item) { states[item] = lost_state(); }
    };
    Queue queue{states};
    follow(AlongFlow<Field>{field_}, from, to, options, queue);
  }

  FlowState integrate_with_derivative(const FlowState& state, double from, double to, FlowMatrix& derivative,
                                      const IntegrationOptions& options) const override {
    double x[n * (1 + n)];
    copy_with_unit_tangents(state, x);
    SingleTrajectory<n*(1 + n)> trajectory{x};
    const bool rough = has_rough_derivatives(field_);
    follow(WithTangents<Field, static_cast<int>(n)>{field_}, from, to,
           rough ? with_rough_derivatives(options) : options, trajectory);
    if (!trajectory.found) return lost_state();
    derivative = tangents(x);
    if (!rough) return widened(x);
    FlowState end = state;
    integrate({&end, 1}, from, to, options);
    return end;
  }

  FlowState integrate_with_action(const FlowState& state, double from, double to, double& action,
                                  const IntegrationOptions& options) const override {
    require_hamiltonian();
    double x[n + 1] = {};
    std::copy_n(state.begin(), n, x);
    SingleTrajectory<n + 1> trajectory{x};
    follow(WithAction<Field>{field_, 0}, from, to, options, trajectory);
    if (!trajectory.found) return lost_state();
    action = x[n];
    return widened(x);
  }

  std::uint64_t to_section(std::span<FlowState> states, std::span<double> times, const Section& section, int crossings,
                           const IntegrationOptions& options) const override {
    if (section.coordinate < 0 || section.coordinate >= Field::dimension) {
      throw UsageError("the section's coordinate does not exist");
    }
    struct Queue {
      std::span<FlowState> states;
      std::span<double> times;
      Arrivals arrivals;
      std::size_t begun = 0;

      bool next(std::size_t& item, double* state) {
        if (begun == states.size()) return false;
        item = begun++;
        std::copy_n(states[item].begin(), n, state);
        arrivals.begin(item);
        if (!times.empty()) times[item] = 0;
        return true;
      }
      bool arrived(std::size_t item, const double* state, double time) {
        states[item] = widened(state);
        if (!times.empty()) times[item] += time;
        return arrivals.again(item);
      }
      void lost(std::size_t item) {
        states[item] = lost_state();
        if (!times.empty()) times[item] = std::numeric_limits<double>::quiet_NaN();
      }
    };
    if constexpr (Field::forcings == 0) {
      if (crossings == 0) {
        std::fill(times.begin(), times.end(), 0.0);
        return 0;
      }
      const AlongFlow<Field> rhs{field_};
      Queue queue{states, times, Arrivals(std::abs(crossings), states.size())};
      const auto control = [&] {
        return SectionLanes<AlongFlow<Field>, Queue>(rhs, section, options, n, crossings < 0 ? -1 : 1, queue);
      };
      return tenths_of_work(field_) * (step_stages + 1) * run_queue(rhs, options.tolerance, control);
    } else {
      throw UsageError("crossings of a section are found for autonomous flows only");
    }
  }

  [[nodiscard]] std::unique_ptr<PlanarMap> stroboscopic_map(double phase,
                                                            const IntegrationOptions& options) const override {
    if constexpr (n == 2 && Field::forcings > 0) {
      if (period() > 0) return std::make_unique<StroboscopicMap<Field>>(field_, phase, options);
    }
    throw UsageError("a stroboscopic map needs a time-periodic flow of two dimensions");
  }

  [[nodiscard]] std::unique_ptr<PlanarMap> section_map(const Section& section, double energy,
                                                       const IntegrationOptions& options) const override {
    if constexpr (has_section_maps) return std::make_unique<SectionMap<Field>>(field_, section, energy, options);
    throw UsageError("a return map needs a flow of three dimensions, or of four with a Hamiltonian");
  }

  [[nodiscard]] FlowState on_section(const Section& section, double energy, Point point) const override {
    if constexpr (has_section_maps) {
      typename SectionChart<Field>::State x;
      return SectionChart<Field>(field_, section, energy).lift(point, x) ? widened(x.data()) : lost_state();
    }
    throw UsageError("a section needs a flow of three dimensions, or of four with a Hamiltonian");
  }

 private:
  static constexpr int n = Field::dimension;
  static_assert(Field::dimension >= 1 && Field::dimension <= max_flow_dimension);
  static constexpr bool has_section_maps = (n == 3 || n == 4) && Field::forcings == 0;

  /// The numbers that the field depends on at a time.
  struct Forcing {
    double numbers[Field::forcings + 1]{};
    Forcing(const Field& field, double time) { field.forcing(time, numbers); }
  };

  void require_hamiltonian() const {
    if (field_.pairs().empty()) throw UsageError("the flow is not Hamiltonian");
  }

  template <typename Rhs, typename Queue>
  void follow(const Rhs& rhs, double from, double to, const IntegrationOptions& options, Queue& queue) const {
    run_queue(rhs, options.tolerance,
              [&] { return SpanLanes<Rhs, Field, Queue>(rhs, field_, from, to, options, n, queue); });
  }
  static FlowState widened(const double* x) {
    FlowState result{};
    std::copy_n(x, n, result.begin());
    return result;
  }
  static FlowState lost_state() {
    FlowState result;
    result.fill(std::numeric_limits<double>::quiet_NaN());
    return result;
  }
  static void copy_with_unit_tangents(const FlowState& state, double (&x)[n * (1 + n)]) {
    std::fill(std::begin(x), std::end(x), 0.0);
    std::copy_n(state.begin(), n, x);
    for (int k = 0; k < n; ++k) x[n * (1 + k) + k] = 1;
  }
  static FlowMatrix tangents(const double (&x)[n * (1 + n)]) {
    FlowMatrix result{};
    for (int k = 0; k < n; ++k) {
      for (int i = 0; i < n; ++i) result[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] = x[n * (1 + k) + i];
    }
    return result;
  }

  Field field_;
};

}  // namespace lober::detail
