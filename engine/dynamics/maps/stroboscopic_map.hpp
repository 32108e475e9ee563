// The map over one period of a time-periodic flow of the plane.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>

#include "engine/dynamics/maps/integrator.hpp"
#include "engine/dynamics/maps/plane.hpp"
#include "engine/dynamics/maps/right_hand_sides.hpp"

namespace lober::detail {

template <typename Field>
class StroboscopicMap final : public PlanarMap {
  static_assert(Field::dimension == 2);

 public:
  StroboscopicMap(Field field, double phase, const IntegrationOptions& options)
      : field_(std::move(field)), period_(field_.period()), start_(phase * period_), options_(options) {}

  void iterate(std::span<Point> points, int iterates) const override {
    const AlongFlow<Field> rhs{field_};
    Integrator<2, AlongFlow<Field>> integrator(rhs, options_, 2);
    const int forward = iterates < 0 ? -1 : 1;
    for (Point& point : points) {
      // Each period begins anew, so that two periods are exactly twice one.
      for (int k = 0; k != iterates; k += forward) {
        integrator.start({point.x, point.y}, start_, forward);
        if (!integrator.advance(start_ + forward * period_)) {
          point = lost_point;
          break;
        }
        point = {integrator.x[0], integrator.x[1]};
      }
    }
    add_work(integrator.evaluations());
  }

  Point iterate_with_derivative(Point point, int iterates, Matrix2& derivative) const override {
    using Rhs = WithTangents<Field, 2>;
    const Rhs rhs{field_};
    Integrator<Rhs::size, Rhs> integrator(rhs, options_.finer(), 2);
    const int forward = iterates < 0 ? -1 : 1;
    derivative = {};
    for (int k = 0; k != iterates; k += forward) {
      integrator.start({point.x, point.y, 1, 0, 0, 1}, start_, forward);
      if (!integrator.advance(start_ + forward * period_)) return lost_point;
      const auto& x = integrator.x;
      point = {x[0], x[1]};
      derivative = Matrix2{x[2], x[4], x[3], x[5]} * derivative;
    }
    return point;
  }

  [[nodiscard]] std::optional<long double> action(Point from, Point to) const override {
    const auto pairs = field_.pairs();
    if (pairs.size() != 1 || pairs[0].q != 0) return std::nullopt;
    using Rhs = WithAction<Field>;
    const Rhs rhs{field_, 1};
    Integrator<Rhs::size, Rhs> integrator(rhs, options_.finer(), 2);
    integrator.start({from.x, from.y, 0}, start_, 1);
    if (!integrator.advance(start_ + period_)) return std::nullopt;
    const long double along = integrator.x[2] / pairs[0].factor;
    return along + static_cast<long double>(to.y) * (static_cast<long double>(to.x) - integrator.x[0]);
  }
  [[nodiscard]] double action_accuracy() const override { return 10 * options_.finer().tolerance; }
  [[nodiscard]] std::unique_ptr<PlanarMap> finer() const override {
    return std::make_unique<StroboscopicMap>(field_, start_ / period_, options_.finer());
  }

 private:
  Field field_;
  double period_;
  double start_;
  IntegrationOptions options_;
};

}  // namespace lober::detail
