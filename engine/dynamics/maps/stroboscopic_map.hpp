// The map over one period of a time-periodic flow of the plane.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "engine/dynamics/integration/period_lanes.hpp"
#include "engine/dynamics/integration/wide_steps.hpp"
#include "engine/dynamics/maps/plane.hpp"
#include "engine/dynamics/maps/right_hand_sides.hpp"

namespace lober::detail {

template <typename Field>
class HalfPeriodMap;

template <typename Field>
class StroboscopicMap final : public PlanarMap {
  static_assert(Field::dimension == 2);

 public:
  StroboscopicMap(Field field, double phase, const IntegrationOptions& options)
      : StroboscopicMap(std::make_shared<ForcingTable<Field>>(field, phase * field.period()), options) {}
  StroboscopicMap(std::shared_ptr<const ForcingTable<Field>> forcing, const IntegrationOptions& options)
      : forcing_(std::move(forcing)), options_(options) {}

  void iterate(std::span<Point> points, int iterates) const override {
    if (iterates != 0) carry(points, std::abs(iterates), iterates < 0 ? -1 : 1, 2, options_);
  }
  /// Replaces every point by that half a period later, or earlier: `forward` is +1 or -1.
  void half_a_period(std::span<Point> points, int forward) const { carry(points, 1, forward, 1, options_); }

  Point iterate_with_derivative(Point point, int iterates, Matrix2& derivative) const override {
    iterate_with_derivatives({&point, 1}, iterates, {&derivative, 1});
    return point;
  }

  void iterate_with_derivatives(std::span<Point> points, int iterates, std::span<Matrix2> derivatives) const override {
    std::fill(derivatives.begin(), derivatives.end(), Matrix2{});
    if (iterates != 0) carry_with_derivatives(points, std::abs(iterates), iterates < 0 ? -1 : 1, 2, derivatives);
  }
  /// The same for half a period, whose derivative is multiplied to `derivatives`.
  void half_a_period(std::span<Point> points, int forward, std::span<Matrix2> derivatives) const {
    carry_with_derivatives(points, 1, forward, 1, derivatives);
  }

  [[nodiscard]] std::optional<long double> action(Point from, Point to) const override {
    const auto pairs = field().pairs();
    if (pairs.size() != 1 || pairs[0].q != 0) return std::nullopt;
    double state[3] = {from.x, from.y, 0};
    if (!period(WithAction<Field>{field(), 1}, 1, state)) return std::nullopt;
    const long double along = state[2] / pairs[0].factor;
    return along + static_cast<long double>(to.y) * (static_cast<long double>(to.x) - state[0]);
  }
  [[nodiscard]] double action_accuracy() const override { return 10 * options_.finer().tolerance; }
  [[nodiscard]] double unit() const override { return unit_of(field()); }
  [[nodiscard]] std::unique_ptr<PlanarMap> finer() const override {
    return std::make_unique<StroboscopicMap>(forcing_, options_.finer());
  }
  [[nodiscard]] std::size_t batch() const override { return wide_batch(AlongFlow<Field>{field()}); }
  [[nodiscard]] std::unique_ptr<PlanarMap> half() const override {
    return std::make_unique<HalfPeriodMap<Field>>(forcing_, options_);
  }

 private:
  [[nodiscard]] const Field& field() const { return forcing_->field(); }

  void carry(std::span<Point> points, int times, int forward, int halves, const IntegrationOptions& options) const {
    // Each period begins anew, so that two periods are exactly twice one.
    struct Queue {
      std::span<Point> points;
      Arrivals arrivals;
      std::size_t begun = 0;

      bool next(std::size_t& item, double* state) {
        if (begun == points.size()) return false;
        item = begun++;
        state[0] = points[item].x;
        state[1] = points[item].y;
        arrivals.begin(item);
        return true;
      }
      bool arrived(std::size_t item, double* state) {
        points[item] = {state[0], state[1]};
        return arrivals.again(item);
      }
      void lost(std::size_t item) { points[item] = lost_point; }
    };
    Queue queue{points, Arrivals(times, points.size())};
    add_tenths_of_work(tenths_of_work(field()) * follow(AlongFlow<Field>{field()}, options, forward, halves, queue));
  }

  void carry_with_derivatives(std::span<Point> points, int times, int forward, int halves,
                              std::span<Matrix2> derivatives) const {
    if (!has_rough_derivatives(field())) {
      carry_with_tangents(points, times, forward, halves, options_.finer(), derivatives);
      return;
    }
    std::vector<Point> beside(points.size());
    for (int k = 0; k < times; ++k) {
      std::copy(points.begin(), points.end(), beside.begin());
      carry_with_tangents(beside, 1, forward, halves, with_rough_derivatives(options_), derivatives);
      carry(points, 1, forward, halves, options_.finer());
    }
  }

  void carry_with_tangents(std::span<Point> points, int times, int forward, int halves,
                           const IntegrationOptions& options, std::span<Matrix2> derivatives) const {
    struct Queue {
      std::span<Point> points;
      std::span<Matrix2> derivatives;
      Arrivals arrivals;
      std::size_t begun = 0;

      bool next(std::size_t& item, double* state) {
        if (begun == points.size()) return false;
        item = begun++;
        arrivals.begin(item);
        begin_period(item, state);
        return true;
      }
      bool arrived(std::size_t item, double* state) {
        points[item] = {state[0], state[1]};
        derivatives[item] = Matrix2{state[2], state[4], state[3], state[5]} * derivatives[item];
        if (!arrivals.again(item)) return false;
        begin_period(item, state);
        return true;
      }
      void lost(std::size_t item) { points[item] = lost_point; }
      void begin_period(std::size_t item, double* state) {
        const double unit[4] = {1, 0, 0, 1};
        state[0] = points[item].x;
        state[1] = points[item].y;
        std::copy(std::begin(unit), std::end(unit), state + 2);
      }
    };
    Queue queue{points, derivatives, Arrivals(times, points.size())};
    // Two tangent vectors beside each point.
    add_tenths_of_derivatives(3 * tenths_of_work(field()) *
                              follow(WithTangents<Field, 2>{field()}, options, forward, halves, queue));
  }

  /// Evaluations of the field.
  template <typename Rhs, typename Queue>
  std::uint64_t follow(const Rhs& rhs, const IntegrationOptions& options, int forward, int halves, Queue& queue) const {
    return step_stages * run_queue(rhs, options.tolerance, [&] {
             return PeriodLanes<Rhs, Field, Queue>(rhs, *forcing_, options, 2, forward, halves, queue);
           });
  }

  /// Replaces the state by that after a period, to finer errors. False: it is lost.
  template <typename Rhs>
  bool period(const Rhs& rhs, int forward, double (&state)[Rhs::size]) const {
    SingleTrajectory<Rhs::size> trajectory{state};
    const IntegrationOptions options = options_.finer();
    follow(rhs, options, forward, 2, trajectory);
    return trajectory.found;
  }

  std::shared_ptr<const ForcingTable<Field>> forcing_;
  IntegrationOptions options_;
};

/// The flow in halves of its period (PlanarMap::half).
template <typename Field>
class HalfPeriodMap final : public PlanarMap {
 public:
  HalfPeriodMap(std::shared_ptr<const ForcingTable<Field>> forcing, const IntegrationOptions& options)
      : whole_(std::move(forcing), options) {}

  void iterate(std::span<Point> points, int iterates) const override {
    whole_.iterate(points, iterates / 2);
    if (iterates % 2 != 0) whole_.half_a_period(points, iterates < 0 ? -1 : 1);
  }
  Point iterate_with_derivative(Point point, int iterates, Matrix2& derivative) const override {
    iterate_with_derivatives({&point, 1}, iterates, {&derivative, 1});
    return point;
  }
  void iterate_with_derivatives(std::span<Point> points, int iterates, std::span<Matrix2> derivatives) const override {
    whole_.iterate_with_derivatives(points, iterates / 2, derivatives);
    if (iterates % 2 != 0) whole_.half_a_period(points, iterates < 0 ? -1 : 1, derivatives);
  }
  [[nodiscard]] double unit() const override { return whole_.unit(); }
  [[nodiscard]] std::size_t batch() const override { return whole_.batch(); }
  [[nodiscard]] std::uint64_t work() const override { return whole_.work(); }
  [[nodiscard]] std::uint64_t work_of_derivatives() const override { return whole_.work_of_derivatives(); }

 private:
  StroboscopicMap<Field> whole_;
};

}  // namespace lober::detail
