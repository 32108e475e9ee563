// The systems on which integrators are compared.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>

#include "bench/integrators/problem.hpp"
#include "engine/dynamics/systems/fields/capsize.hpp"
#include "engine/dynamics/systems/fields/duffing.hpp"
#include "engine/dynamics/systems/fields/three_body.hpp"
#include "engine/dynamics/systems/fields/vortex_pair.hpp"
#include "lober/dynamics/systems.hpp"

namespace lober::bench {

/// The same numbers every time, in [from, to).
class Draw {
 public:
  double operator()(double from, double to) {
    return from + (to - from) * std::ldexp(static_cast<double>(engine_() >> 11U), -53);
  }

 private:
  std::mt19937_64 engine_{1};
};

/// Around the separatrix, where manifolds are.
inline Problem<VortexPair> vortex_pair_problem(std::size_t count) {
  const VortexPair field(0.5, 0.1);
  Problem<VortexPair> result{"ovp", "vortex pair, one period", field, field.period(), {}};
  Draw draw;
  for (std::size_t k = 0; k < count; ++k) {
    const double angle = draw(0.05, 3.05), size = draw(0.95, 1.05);
    result.points.push_back({1.8 * size * std::cos(angle), 2 * size * std::sin(angle)});
  }
  return result;
}

inline Problem<Duffing> duffing_problem(std::size_t count) {
  const Duffing field{{0.1, 1, 0}};
  Problem<Duffing> result{"duffing", "Duffing oscillator, one period", field, field.period(), {}};
  Draw draw;
  for (std::size_t k = 0; k < count; ++k) {
    const double x = draw(-1.5, 1.5);
    result.points.push_back({x, draw(-1, 1)});
  }
  return result;
}

/// In the well, below the energy of escape.
inline Problem<Capsize> capsize_problem(std::size_t count) {
  Problem<Capsize> result{"capsize", "ship capsize, time 7", Capsize(1.6), 7, {}};
  Draw draw;
  while (result.points.size() < count) {
    StateOf<Capsize> point{};
    for (double& coordinate : point) coordinate = draw(-1, 1);
    if (point[1] < 0.5 && result.field.hamiltonian(point.data(), nullptr) < 0.24) result.points.push_back(point);
  }
  return result;
}

/// From the section of the return map, outside of the smaller body's orbit and opposite to it.
inline Problem<ThreeBody> three_body_problem(std::size_t count) {
  const System system = make_system("pcr3bp");
  Problem<ThreeBody> result{"pcr3bp", "three-body problem, time 7", ThreeBody{9.537e-4}, 7, {}};
  Draw draw;
  while (result.points.size() < count) {
    const double x = draw(-2.03, -1.2);
    const FlowState state = system.flow->on_section(*system.section, -1.525, {x, draw(-0.1, 0.1)});
    if (!std::isnan(state[3])) result.points.push_back({state[0], state[1], state[2], state[3]});
  }
  return result;
}

}  // namespace lober::bench
