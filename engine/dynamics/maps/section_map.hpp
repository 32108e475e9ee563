// The first return map of an autonomous flow to a section, on a surface of constant energy where there is a
// Hamiltonian.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/dynamics/integration/section_lanes.hpp"
#include "engine/dynamics/integration/wide_steps.hpp"
#include "engine/dynamics/maps/plane.hpp"
#include "engine/dynamics/maps/right_hand_sides.hpp"
#include "lober/base/error.hpp"

namespace lober::detail {

/// The maps from the chart of a section to phase space and back.
template <typename Field>
class SectionChart {
 public:
  static constexpr std::size_t n = Field::dimension;
  using State = std::array<double, n>;
  static_assert(Field::forcings == 0);

  /// Throws UsageError when the section does not fit the flow.
  SectionChart(const Field& field, const Section& section, double energy)
      : field_(field), section_(section), energy_(energy) {
    const auto bad = [](int coordinate) { return coordinate < 0 || coordinate >= static_cast<int>(n); };
    const bool hamiltonian = !field.pairs().empty();
    if (n != (hamiltonian ? 4 : 3)) {
      throw UsageError("a return map needs a flow of three dimensions, or of four with a Hamiltonian");
    }
    if (field.period() != 0) throw UsageError("a return map needs an autonomous flow");
    std::array<bool, n> used{};
    for (const int coordinate : {section.coordinate, section.chart_x, section.chart_y, section.solved}) {
      if (coordinate == section.solved && !hamiltonian && coordinate == -1) continue;
      if (bad(coordinate) || used[static_cast<std::size_t>(coordinate)]) {
        throw UsageError("the section must name each coordinate of the flow once");
      }
      used[static_cast<std::size_t>(coordinate)] = true;
    }
    if (!(section.period >= 0 && std::isfinite(section.period))) {
      throw UsageError("the period of the section's coordinate must be 0 or positive");
    }
    if (section.direction == 0) throw UsageError("a return map needs a direction of crossing");
    if (bad(section.bound_coordinate)) throw UsageError("the section is bounded in a coordinate that does not exist");
    if (!hamiltonian) return;
    conjugate_ = pair_of(section.coordinate);
    if (conjugate_.q != section.coordinate || conjugate_.p != section.solved) {
      throw UsageError("the coordinate solved for must be conjugate to that of the section");
    }
  }

  /// The state of a point; false where the energy does not reach, where the flow crosses in the other direction, or
  /// outside the section's bound.
  [[nodiscard]] bool lift(Point point, State& x) const {
    x = {};
    x[at(section_.coordinate)] = section_.value;
    x[at(section_.chart_x)] = point.x;
    x[at(section_.chart_y)] = point.y;
    if (section_.bound_side * (x[at(section_.bound_coordinate)] - section_.bound) < 0) return false;
    if constexpr (n != 3) {
      return solve(x);
    } else {
      State v;
      field_.velocity(x.data(), v.data(), x.data());
      return section_.direction * v[at(section_.coordinate)] > 0;
    }
  }

  [[nodiscard]] Point project(const double* x) const { return {x[at(section_.chart_x)], x[at(section_.chart_y)]}; }

  /// The tangent vectors of the lifted chart at x, the velocity there being v.
  [[nodiscard]] std::array<State, 2> frame(const State& v) const {
    std::array<State, 2> vectors{};
    const std::array<int, 2> chart{section_.chart_x, section_.chart_y};
    for (std::size_t k = 0; k < 2; ++k) {
      vectors[k][at(chart[k])] = 1;
      if (n == 4) vectors[k][at(section_.solved)] = -slope(chart[k], v) / slope(section_.solved, v);
    }
    return vectors;
  }

  [[nodiscard]] const Section& section() const { return section_; }
  [[nodiscard]] double energy() const { return energy_; }
  /// The factor of the chart's conjugate pair; 0 when the chart is not such a pair.
  [[nodiscard]] double chart_factor() const {
    for (const ConjugatePair& pair : field_.pairs()) {
      if (pair.q == section_.chart_x && pair.p == section_.chart_y) return pair.factor;
    }
    return 0;
  }

 private:
  static std::size_t at(int coordinate) { return static_cast<std::size_t>(coordinate); }

  [[nodiscard]] ConjugatePair pair_of(int coordinate) const {
    for (const ConjugatePair& pair : field_.pairs()) {
      if (pair.q == coordinate || pair.p == coordinate) return pair;
    }
    throw UsageError("a coordinate of the section belongs to no conjugate pair");
  }

  /// dH / d(state[coordinate]), read off the velocity v by Hamilton's equations.
  [[nodiscard]] double slope(int coordinate, const State& v) const {
    const ConjugatePair pair = pair_of(coordinate);
    return coordinate == pair.q ? -pair.factor * v[at(pair.p)] : pair.factor * v[at(pair.q)];
  }

  /// Fills in the solved coordinate: H is a v^2 + b v + c in it, known from three values.
  [[nodiscard]] bool solve(State& x) const {
    double& v = x[at(section_.solved)];
    double unit = 1;
    const auto excess = [&](double units) {
      v = units * unit;
      return field_.hamiltonian(x.data(), x.data()) - energy_;
    };
    double a = 0, b = 0, c = 0;
    const auto measure = [&] {
      const double below = excess(-1), above = excess(1);
      c = excess(0);
      a = 0.5 * (above + below) - c;
      b = 0.5 * (above - below);
    };
    measure();
    if constexpr (has_own_units<Field>) {
      // A unit in which v adds about as much to the energy as there is of it.
      constexpr double far = 4096, out_of_sight = 1e-9;
      const double energy = std::abs(energy_) + std::abs(c + energy_);
      const auto part = [&] { return std::max(std::abs(a), std::abs(b)); };
      if (energy > 0 && (part() > far * energy || far * part() < energy)) {
        for (int k = 0; k < 60 && part() <= out_of_sight * energy; ++k) {  // lost in the rounding of the rest
          unit *= 1e4;
          measure();
        }
        unit *= std::min(std::sqrt(energy / std::abs(a)), energy / std::abs(b));
        measure();
      }
    }
    const double scale = std::abs(a) + std::abs(b) + std::abs(c);
    if (std::abs(excess(2) - (4 * a + 2 * b + c)) > 1e-9 * scale) {
      throw UsageError("the Hamiltonian is not quadratic in the coordinate that the section solves for");
    }
    const double discriminant = b * b - 4 * a * c;
    // At the edge of what the energy reaches the chart is singular: a trajectory there is tangent to the section.
    if (!(discriminant > 1e-12 * scale * scale)) return false;
    // dH/dv = 2 a v + b has the sign of the crossing.
    const double wanted = std::copysign(std::sqrt(discriminant), section_.direction * conjugate_.factor);
    double root = wanted * b > 0 ? -2 * c / (b + wanted) : (wanted - b) / (2 * a);
    root -= excess(root) / wanted;
    v = root * unit;
    return std::isfinite(v);
  }

  Field field_;
  Section section_;
  double energy_;
  ConjugatePair conjugate_;
};

template <typename Field>
class SectionMap final : public PlanarMap {
 public:
  SectionMap(const Field& field, const Section& section, double energy, const IntegrationOptions& options)
      : field_(field), chart_(field, section, energy), options_(options) {}

  void iterate(std::span<Point> points, int iterates) const override {
    if (iterates != 0) carry(points, iterates, options_);
  }

  bool is_defined_at(Point point) const override {
    typename SectionChart<Field>::State state;
    return chart_.lift(point, state);
  }

  Point iterate_with_derivative(Point point, int iterates, Matrix2& derivative) const override {
    iterate_with_derivatives({&point, 1}, iterates, {&derivative, 1});
    return point;
  }

  void iterate_with_derivatives(std::span<Point> points, int iterates, std::span<Matrix2> derivatives) const override {
    std::fill(derivatives.begin(), derivatives.end(), Matrix2{});
    if (iterates == 0) return;
    if (!has_rough_derivatives(field_)) {
      carry_with_tangents(points, iterates, options_.finer(), derivatives);
      return;
    }
    std::vector<Point> beside(points.size());
    const int forward = iterates < 0 ? -1 : 1;
    for (int k = 0; k < std::abs(iterates); ++k) {
      std::copy(points.begin(), points.end(), beside.begin());
      carry_with_tangents(beside, forward, with_rough_derivatives(options_), derivatives);
      carry(points, forward, options_.finer());
    }
  }

  [[nodiscard]] std::optional<long double> action(Point from, Point to) const override {
    const double factor = chart_.chart_factor();
    State x;
    if (factor == 0 || !chart_.lift(from, x)) return std::nullopt;
    double state[n + 1] = {};
    std::copy(x.begin(), x.end(), state);
    SingleTrajectory<n + 1> trajectory{state};
    const IntegrationOptions options = options_.finer();
    follow(WithAction<Field>{field_, 0}, options, 1, trajectory);
    if (!trajectory.found) return std::nullopt;
    return state[n] / static_cast<long double>(factor) +
           static_cast<long double>(to.y) * (static_cast<long double>(to.x) - chart_.project(state).x);
  }
  [[nodiscard]] double unit() const override { return unit_of(field_); }
  [[nodiscard]] double action_accuracy() const override { return 10 * options_.finer().tolerance; }
  [[nodiscard]] std::size_t batch() const override { return wide_batch(AlongFlow<Field>{field_}); }
  [[nodiscard]] std::unique_ptr<PlanarMap> finer() const override {
    return std::make_unique<SectionMap>(field_, chart_.section(), chart_.energy(), options_.finer());
  }

 private:
  static constexpr std::size_t n = Field::dimension;
  using State = std::array<double, n>;

  void carry(std::span<Point> points, int iterates, const IntegrationOptions& options) const {
    // Each return begins anew from the point, so that two returns are exactly twice one.
    struct Queue {
      const SectionChart<Field>& chart;
      std::span<Point> points;
      Arrivals arrivals;
      std::size_t begun = 0;

      bool next(std::size_t& item, double* state) {
        while (begun < points.size()) {
          item = begun++;
          if (lifted(item, state)) {
            arrivals.begin(item);
            return true;
          }
        }
        return false;
      }
      bool arrived(std::size_t item, double* state, double /*time*/) {
        points[item] = chart.project(state);
        return arrivals.again(item) && lifted(item, state);
      }
      void lost(std::size_t item) { points[item] = lost_point; }
      bool lifted(std::size_t item, double* state) {
        State x;
        if (!chart.lift(points[item], x)) {
          lost(item);
          return false;
        }
        std::copy(x.begin(), x.end(), state);
        return true;
      }
    };
    Queue queue{chart_, points, Arrivals(std::abs(iterates), points.size())};
    add_tenths_of_work(tenths_of_work(field_) *
                       follow(AlongFlow<Field>{field_}, options, iterates < 0 ? -1 : 1, queue));
  }

  /// Multiplies the derivatives of the returns to `derivatives`.
  void carry_with_tangents(std::span<Point> points, int iterates, const IntegrationOptions& options,
                           std::span<Matrix2> derivatives) const {
    struct Queue {
      const SectionMap& map;
      std::span<Point> points;
      std::span<Matrix2> derivatives;
      Arrivals arrivals;
      std::size_t begun = 0;

      bool next(std::size_t& item, double* state) {
        while (begun < points.size()) {
          item = begun++;
          arrivals.begin(item);
          if (begin_return(item, state)) return true;
        }
        return false;
      }
      bool arrived(std::size_t item, double* state, double /*time*/) {
        points[item] = map.chart_.project(state);
        derivatives[item] = map.derivative_on_section(state) * derivatives[item];
        return arrivals.again(item) && begin_return(item, state);
      }
      void lost(std::size_t item) { points[item] = lost_point; }
      bool begin_return(std::size_t item, double* state) {
        if (map.begin_with_tangents(points[item], state)) return true;
        lost(item);
        return false;
      }
    };
    Queue queue{*this, points, derivatives, Arrivals(std::abs(iterates), points.size())};
    // Two tangent vectors beside each point.
    add_tenths_of_derivatives(3 * tenths_of_work(field_) *
                              follow(WithTangents<Field, 2>{field_}, options, iterates < 0 ? -1 : 1, queue));
  }

  /// The state of a point of the section, and the tangent vectors of the chart there. False: there is none.
  bool begin_with_tangents(Point point, double* state) const {
    State x, v;
    if (!chart_.lift(point, x)) return false;
    field_.velocity(x.data(), v.data(), x.data());
    std::copy(x.begin(), x.end(), state);
    const auto frame = chart_.frame(v);
    for (std::size_t k = 0; k < 2; ++k) std::copy(frame[k].begin(), frame[k].end(), state + n * (1 + k));
    return true;
  }
  /// The derivative of a return, from the state and the tangent vectors where it ends.
  Matrix2 derivative_on_section(double* state) const {
    State v;
    field_.velocity(state, v.data(), state);
    // Along the flow back onto the section.
    const auto axis = static_cast<std::size_t>(chart_.section().coordinate);
    std::array<Point, 2> column;
    for (std::size_t k = 0; k < 2; ++k) {
      double* const w = state + n * (1 + k);
      const double share = w[axis] / v[axis];
      for (std::size_t i = 0; i < n; ++i) w[i] -= share * v[i];
      column[k] = chart_.project(w);
    }
    return {column[0].x, column[1].x, column[0].y, column[1].y};
  }

  /// Evaluations of the field.
  template <typename Rhs, typename Queue>
  std::uint64_t follow(const Rhs& rhs, const IntegrationOptions& options, int forward, Queue& queue) const {
    return (step_stages + 1) * run_queue(rhs, options.tolerance, [&] {
             return SectionLanes<Rhs, Queue>(rhs, chart_.section(), options, n, forward, queue);
           });
  }

  Field field_;
  SectionChart<Field> chart_;
  IntegrationOptions options_;
};

}  // namespace lober::detail
