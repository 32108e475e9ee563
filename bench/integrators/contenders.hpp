// Everything that integrates: the methods in lanes, lober itself and Boost.Odeint.
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "bench/integrators/methods.hpp"
#include "bench/integrators/odeint.hpp"
#include "bench/integrators/period_run.hpp"
#include "bench/integrators/problem.hpp"
#include "bench/integrators/span_run.hpp"
#include "lober/dynamics/systems.hpp"

namespace lober::bench {

template <typename Field>
struct Contender {
  std::string name;
  bool in_lanes;  ///< else slow, and run on fewer points
  std::vector<double> tolerances;
  Integration<Field> integrate;
};

/// Through its interface, as a map or a flow with one call for all points. The system of a tolerance is made once, as
/// its users do.
template <typename Field>
Integration<Field> by_lober(const Problem<Field>& problem) {
  return [&problem, systems = std::map<double, System>()](double tolerance, std::span<StateOf<Field>> points) mutable {
    IntegrationOptions options;
    options.tolerance = tolerance;
    if (!systems.contains(tolerance)) systems.emplace(tolerance, make_system(problem.name, {}, options));
    const System& system = systems.at(tolerance);
    if constexpr (Field::forcings > 0) {
      std::vector<Point> moved;
      moved.reserve(points.size());
      for (const StateOf<Field>& x : points) moved.push_back({x[0], x[1]});
      system.map->iterate(moved, 1);
      for (std::size_t k = 0; k < points.size(); ++k) points[k] = {moved[k].x, moved[k].y};
    } else {
      std::vector<FlowState> moved(points.size());
      for (std::size_t k = 0; k < points.size(); ++k) std::copy(points[k].begin(), points[k].end(), moved[k].begin());
      system.flow->integrate(moved, 0, problem.span, options);
      for (std::size_t k = 0; k < points.size(); ++k) {
        std::copy_n(moved[k].begin(), points[k].size(), points[k].begin());
      }
    }
  };
}

template <typename Method, typename Field>
Integration<Field> in_lanes(const Problem<Field>& problem) {
  using Run = std::conditional_t<Field::forcings == 0, SpanRun<Method, Field>, PeriodRun<Method, Field>>;
  // Shared, so that tables are computed once.
  return [run = std::make_shared<Run>(problem)](double tolerance, std::span<StateOf<Field>> points) {
    (*run)(tolerance, points);
  };
}

template <typename Field, typename... Methods>
void add_methods(std::vector<Contender<Field>>& contenders, const Problem<Field>& problem, MethodList<Methods...>) {
  const std::vector<double> tolerances{1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14};
  (contenders.push_back({Methods::name(), true, tolerances, in_lanes<Methods>(problem)}), ...);
}

/// The problem must outlive them.
template <typename Field>
std::vector<Contender<Field>> contenders_of(const Problem<Field>& problem) {
  // Wider, so that others can be compared with it at equal errors. Below 1e-13 the Bulirsch-Stoer method of Odeint is
  // lost in rounding.
  const std::vector<double> wide{1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15};
  const std::vector<double> narrow{1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13};
  std::vector<Contender<Field>> result;
  result.push_back({"Odeint Fehlberg 7(8)", false, wide, odeint_fehlberg(problem)});
  result.push_back({"Odeint Bulirsch-Stoer", false, narrow, odeint_bulirsch_stoer(problem)});
  result.push_back({"lober", true, {1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14}, by_lober(problem)});
  add_methods(result, problem, LaneMethods{});
  return result;
}

}  // namespace lober::bench
