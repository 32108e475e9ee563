// Boost.Odeint, one point at a time.
#pragma once

#include <algorithm>
#include <array>
#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <span>

#include "bench/integrators/problem.hpp"

namespace lober::bench {

template <typename Field>
struct PlainRightHandSide {
  const Field& field;
  void operator()(const StateOf<Field>& x, StateOf<Field>& slope, double t) const {
    double force[Field::forcings + 1];
    field.forcing(t, force);
    field.velocity(x.data(), slope.data(), force);
  }
};

/// Its first step is that of lober when it used this library: the eighth root of the tolerance, by size and speed.
template <typename Field, typename MakeStepper>
Integration<Field> by_odeint(const Problem<Field>& problem, const MakeStepper& make_stepper) {
  return [&problem, make_stepper](double tolerance, std::span<StateOf<Field>> points) {
    const PlainRightHandSide<Field> rhs{problem.field};
    for (StateOf<Field>& x : points) {
      StateOf<Field> slope;
      rhs(x, slope, 0);
      double size = 0, speed = 0;
      for (std::size_t i = 0; i < x.size(); ++i) {
        size = std::max(size, std::abs(x[i]));
        speed = std::max(speed, std::abs(slope[i]));
      }
      const double first = std::pow(tolerance, 0.125) * (1 + size) / std::max(speed, 1e-3);
      boost::numeric::odeint::integrate_adaptive(make_stepper(tolerance), rhs, x, 0.0, problem.span,
                                                 std::min(first, problem.span));
    }
  };
}

template <typename Field>
Integration<Field> odeint_fehlberg(const Problem<Field>& problem) {
  return by_odeint(problem, [](double tolerance) {
    using Stepper = boost::numeric::odeint::runge_kutta_fehlberg78<StateOf<Field>>;
    return boost::numeric::odeint::make_controlled<Stepper>(tolerance, tolerance);
  });
}

template <typename Field>
Integration<Field> odeint_bulirsch_stoer(const Problem<Field>& problem) {
  return by_odeint(problem, [](double tolerance) {
    return boost::numeric::odeint::bulirsch_stoer<StateOf<Field>>(tolerance, tolerance, 1.0, 1.0);
  });
}

}  // namespace lober::bench
