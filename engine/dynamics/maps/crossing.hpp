// Where a trajectory crosses a section.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "engine/dynamics/maps/integrator.hpp"
#include "lober/flow.hpp"

namespace lober::detail {

/// The cubic on [0, h] with given values and slopes at the ends.
struct HermiteCubic {
  double value0, slope0, value1, slope1, h;

  [[nodiscard]] double operator()(double s) const {
    const double u = s / h;
    const double v = 1 - u;
    return v * v * ((1 + 2 * u) * value0 + s * slope0) + u * u * ((1 + 2 * v) * value1 - (h - s) * slope1);
  }
  /// A zero between `a`, where the sign is `sign_a`, and `b`, where it is the other one.
  [[nodiscard]] double zero(double a, double b, double sign_a) const {
    for (int k = 0; k < 40; ++k) {
      const double middle = 0.5 * (a + b);
      ((*this)(middle)*sign_a > 0 ? a : b) = middle;
    }
    return 0.5 * (a + b);
  }
};

/// Follows trajectories to their crossings of a section, in either direction of time. The integrator's state begins
/// with the coordinates of phase space.
template <std::size_t N, typename Rhs>
class CrossingFinder {
 public:
  using State = std::array<double, N>;

  CrossingFinder(Integrator<N, Rhs>& integrator, const Rhs& rhs, const Section& section, double max_time)
      : integrator_(integrator), rhs_(rhs), section_(section), max_time_(max_time) {}

  State state{};    ///< at the crossing, its section coordinate exactly section.value
  double time = 0;  ///< of the crossing

  /// Follows the trajectory from `start`, at time 0, to the next crossing that counts. False: there is none.
  bool next(const State& start, int forward) {
    integrator_.start(start, 0, forward);
    double side = sign(start);
    if (side == 0) side = forward * integrator_.dxdt[axis()];
    if (side == 0) return false;  // along the section
    while (integrator_.step(forward * max_time_)) {
      if (crossed(side, forward)) return true;
      if (std::abs(integrator_.t) >= max_time_) return false;
    }
    return false;
  }

 private:
  [[nodiscard]] std::size_t axis() const { return static_cast<std::size_t>(section_.coordinate); }
  [[nodiscard]] double sign(const State& x) const { return x[axis()] - section_.value; }

  /// Whether the last step holds a crossing that counts; `side` (of which only the sign matters) is kept up to date.
  bool crossed(double& side, int forward) {
    const double h = integrator_.t - integrator_.t_before;
    const HermiteCubic cubic{sign(integrator_.x_before), integrator_.dxdt_before[axis()], sign(integrator_.x),
                             integrator_.dxdt[axis()], h};
    double begin = 0;
    if (side * cubic.value1 > 0) {
      const std::optional<double> beyond = excursion(cubic, side);
      if (!beyond) return false;
      // There and back within one step: the crossings before and after *beyond.
      if (located(cubic, begin, *beyond, side, forward)) return true;
      side = -side;
      begin = *beyond;
    }
    if (located(cubic, begin, h, side, forward)) return true;
    side = cubic.value1 != 0 ? cubic.value1 : forward * cubic.slope1;
    return false;
  }

  /// A time within the step at which the trajectory is on the other side, though it is on `side` at both ends.
  std::optional<double> excursion(const HermiteCubic& cubic, double side) {
    if (side * cubic.slope0 * cubic.h >= 0 || side * cubic.slope1 * cubic.h <= 0) return std::nullopt;
    // The turning point between the ends, by regula falsi and bisection on the slope of the true trajectory.
    double a = 0, b = cubic.h, slope_a = cubic.slope0, slope_b = cubic.slope1;
    for (int k = 0; k < 60; ++k) {
      double s = k % 3 == 2 ? 0.5 * (a + b) : a - slope_a * (b - a) / (slope_b - slope_a);
      if (!(std::min(a, b) < s && s < std::max(a, b))) s = 0.5 * (a + b);
      const State x = integrator_.part_of_step(s);
      if (sign(x) * side <= 0) return s;
      State dxdt;
      rhs_(x, dxdt, integrator_.t_before + s);
      const double slope = dxdt[axis()];
      // What is left of the way down, were the slope to stay the largest seen.
      const double steepest = std::max(std::abs(slope_a), std::abs(slope_b));
      (slope * slope_a > 0 ? a : b) = s;
      (slope * slope_a > 0 ? slope_a : slope_b) = slope;
      if (std::abs(sign(x)) > steepest * std::abs(b - a) || std::abs(b - a) <= 1e-13 * std::abs(cubic.h)) break;
    }
    return std::nullopt;
  }

  /// Locates the crossing between the times a and b of the step, where the trajectory leaves `side`, if it counts.
  bool located(const HermiteCubic& cubic, double a, double b, double side, int forward) {
    if (section_.direction != 0 && -side * forward * section_.direction < 0) return false;
    double s = cubic.zero(a, b, side);
    for (int k = 0; k < 60; ++k) {
      state = integrator_.part_of_step(s);
      const double off = sign(state);
      if (off == 0) break;
      (off * side > 0 ? a : b) = s;
      State dxdt;
      rhs_(state, dxdt, integrator_.t_before + s);
      double next = s - off / dxdt[axis()];
      if (next == s || !std::isfinite(off)) break;
      if (!(std::min(a, b) <= next && next <= std::max(a, b))) next = 0.5 * (a + b);
      if (std::abs(next - s) <= 1e-15 * std::abs(cubic.h)) break;
      s = next;
    }
    state[axis()] = section_.value;
    time = integrator_.t_before + s;
    const auto bound_axis = static_cast<std::size_t>(section_.bound_coordinate);
    return section_.bound_side * (state[bound_axis] - section_.bound) >= 0 || section_.bound_side == 0;
  }

  Integrator<N, Rhs>& integrator_;
  const Rhs& rhs_;
  Section section_;
  double max_time_;
};

}  // namespace lober::detail
