// One trajectory of dx/dt = rhs(x, t), followed step by step: Runge-Kutta-Fehlberg 7(8) of Boost.Odeint, carried on
// with the result of order 8. On the oscillating vortex pair at 1e-12 it costs 346 evaluations of the field for a
// period and errs by 1.2e-11 at most, Odeint's Bulirsch-Stoer 364 and 5e-11, Dormand-Prince 5 938 and 4e-12.
#pragma once

#include <algorithm>
#include <array>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>

#include "lober/cancellation.hpp"
#include "lober/flow.hpp"

namespace lober::detail {

/// A right-hand side whose last component is an integral along the trajectory, on which nothing else depends. The
/// error estimate of Fehlberg's pair, h 41/840 (k_1 + k_11 - k_12 - k_13), is exactly zero for a function of time
/// alone: k_1 and k_12 are taken at the same time, k_11 and k_13 too. Where the state rests, as at an equilibrium under
/// a forced Hamiltonian, steps would grow without a bound and the integral be worthless. So that component is computed
/// once more in two half steps, and the difference counts as its error.
template <typename Rhs>
concept EndsInIntegral = Rhs::ends_in_integral;

/// Rhs: void operator()(const State& x, State& dxdt, double t) const. Only the first `guarded` components are compared
/// with options.escape (the others are tangent vectors and the like, which may grow).
template <std::size_t N, typename Rhs>
class Integrator {
 public:
  using State = std::array<double, N>;

  Integrator(const Rhs& rhs, const IntegrationOptions& options, std::size_t guarded)
      : rhs_(rhs), options_(options), guarded_(guarded), checker_(options.tolerance, options.tolerance) {}

  /// Begins a trajectory in the direction of time `forward` (+1 or -1).
  void start(const State& state, double time, int forward) {
    x = state;
    t = time;
    tries_ = 0;
    rhs_(x, dxdt, t);
    h_ = forward * first_step();
  }

  /// One step, not beyond `limit` and exactly to it if that is within reach. False: the trajectory is lost. Throws
  /// Cancelled.
  bool step(double limit) {
    x_before = x;
    dxdt_before = dxdt;
    t_before = t;
    for (;;) {
      throw_if_cancelled();
      ++steps_tried_;
      if (++tries_ > options_.max_steps) return false;
      const double rest = limit - t_before;
      // The last two steps share what is left, so that none is a mere remainder.
      const bool last = std::abs(rest) <= std::abs(h_);
      const bool shortened = !last && std::abs(rest) < 2 * std::abs(h_);
      const double h = last ? rest : shortened ? 0.5 * rest : h_;
      if (t_before + h == t_before && h != rest) return false;
      State error;
      stepper_.do_step(std::cref(rhs_), x_before, dxdt_before, t_before, x, h, error);
      double size = checker_.error(stepper_.algebra(), x_before, dxdt_before, error, h);
      if constexpr (EndsInIntegral<Rhs>) {
        if (size <= 1) size = std::max(size, error_of_integral(h));
      }
      if (size <= 1) {
        t = last ? limit : t_before + h;
        // A step cut short says little about the next one.
        const double proposed = adjuster_.increase_step(h, size, Stepper::stepper_order_value);
        if (!(last || shortened) || std::abs(proposed) > std::abs(h_)) h_ = proposed;
        break;
      }
      h_ = std::isfinite(size) ? adjuster_.decrease_step(h, size, Stepper::error_order_value) : 0.2 * h;
    }
    if (!in_bounds()) return false;
    rhs_(x, dxdt, t);
    return true;
  }

  /// Follows the trajectory to the time `end`. False: it is lost.
  bool advance(double end) {
    while (t != end) {
      if (!step(end)) return false;
    }
    return true;
  }

  /// Where a single step of length h from the beginning of the last step leads, for h not longer than that step.
  State part_of_step(double h) {
    State result;
    stepper_.do_step(std::cref(rhs_), x_before, dxdt_before, t_before, result, h);
    return result;
  }

  /// Of the right-hand side, on all trajectories: 13 for each step tried, near enough.
  [[nodiscard]] std::uint64_t evaluations() const { return 13 * steps_tried_; }

  State x{}, dxdt{};
  double t = 0;
  /// Where the last step began.
  State x_before{}, dxdt_before{};
  double t_before = 0;

 private:
  /// How much the last component of x differs from that of two half steps, by the measure of the error checker.
  double error_of_integral(double h) {
    constexpr std::size_t last = N - 1;
    State half, dxdt_half, end;
    stepper_.do_step(std::cref(rhs_), x_before, dxdt_before, t_before, half, h / 2);
    rhs_(half, dxdt_half, t_before + h / 2);
    stepper_.do_step(std::cref(rhs_), half, dxdt_half, t_before + h / 2, end, h / 2);
    const double scale =
        options_.tolerance * (1 + std::abs(x_before[last]) + std::abs(h) * std::abs(dxdt_before[last]));
    return std::abs(x[last] - end[last]) / scale;
  }

  using Stepper = boost::numeric::odeint::runge_kutta_fehlberg78<State>;
  using Checker = boost::numeric::odeint::default_error_checker<double, typename Stepper::algebra_type,
                                                                typename Stepper::operations_type>;
  using Adjuster = boost::numeric::odeint::default_step_adjuster<double, double>;

  /// A step on which the guarded coordinates change by about the eighth root of the tolerance, relative to their size
  /// (Hairer, Norsett & Wanner, II.4, in short): from the point alone, so that a point does not depend on its batch.
  [[nodiscard]] double first_step() const {
    double size = 0, speed = 0;
    for (std::size_t k = 0; k < guarded_; ++k) {
      size = std::max(size, std::abs(x[k]));
      speed = std::max(speed, std::abs(dxdt[k]));
    }
    return std::pow(options_.tolerance, 0.125) * std::clamp((1 + size) / std::max(speed, 1e-3), 1e-6, 10.0);
  }

  [[nodiscard]] bool in_bounds() const {
    for (std::size_t k = 0; k < N; ++k) {
      const double limit = k < guarded_ ? options_.escape : 1e300;
      if (!(std::abs(x[k]) <= limit)) return false;
    }
    return true;
  }

  const Rhs& rhs_;
  IntegrationOptions options_;
  std::size_t guarded_;
  Stepper stepper_;
  Checker checker_;
  Adjuster adjuster_;
  double h_ = 0;
  int tries_ = 0;  // on this trajectory
  std::uint64_t steps_tried_ = 0;
};

}  // namespace lober::detail
