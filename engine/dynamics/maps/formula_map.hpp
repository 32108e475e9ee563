// Planar maps that are given by formulas.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include "engine/dynamics/maps/plane.hpp"
#include "lober/dynamics/planar_map.hpp"

namespace lober::detail {

template <typename F>
concept HasAction = requires(const F& formula, Point point) {
  { formula.action(point, point) } -> std::same_as<long double>;
};

/// A formula that steps many points at a time by itself: void iterate(std::span<Point>, int) const, either way.
template <typename F>
concept StepsMany = requires(const F& formula, std::span<Point> points) {
  formula.iterate(points, 1);
};

/// Makes a PlanarMap of a value type with
///   Point forward(Point) const, Point backward(Point) const, Matrix2 derivative(Point) const (of forward),
/// and, where it has them, iterate (StepsMany) and long double action(Point, Point) const. The calls are inlined into
/// the loop over the points.
template <typename Formula>
class FormulaMap final : public PlanarMap {
 public:
  explicit FormulaMap(Formula formula) : formula_(std::move(formula)) {}

  void iterate(std::span<Point> points, int iterates) const override {
    // A few points at a time, so that the steps of different points overlap in the processor.
    constexpr std::size_t together = 256;
    for (std::size_t begin = 0; begin < points.size(); begin += together) {
      const std::span<Point> some = points.subspan(begin, std::min(together, points.size() - begin));
      step(some, iterates);
      for (Point& point : some) {
        if (!is_finite(point)) point = lost_point;
      }
    }
  }

  // Each call has costs of its own, which fewer points would not hide.
  [[nodiscard]] std::size_t batch() const override { return 128; }

  Point iterate_with_derivative(Point point, int iterates, Matrix2& derivative) const override {
    derivative = {};
    for (int k = 0; k < iterates; ++k) {
      derivative = formula_.derivative(point) * derivative;
      point = formula_.forward(point);
    }
    for (int k = 0; k > iterates; --k) {
      point = formula_.backward(point);
      derivative = inverse(formula_.derivative(point)) * derivative;
    }
    return is_finite(point) ? point : lost_point;
  }

  [[nodiscard]] double unit() const override {
    if constexpr (requires { formula_.unit(); }) return formula_.unit();
    return 1;
  }

  [[nodiscard]] std::optional<long double> action(Point from, Point to) const override {
    if constexpr (HasAction<Formula>) return formula_.action(from, to);
    return std::nullopt;
  }

 private:
  void step(std::span<Point> points, int iterates) const {
    if constexpr (StepsMany<Formula>) {
      formula_.iterate(points, iterates);
    } else {
      for (int k = 0; k < iterates; ++k) {
        for (Point& point : points) point = formula_.forward(point);
      }
      for (int k = 0; k > iterates; --k) {
        for (Point& point : points) point = formula_.backward(point);
      }
    }
  }

  Formula formula_;
};

}  // namespace lober::detail
