// Trajectories in lanes by any method: the same driver for all of them, that of engine/dynamics/integration in short.
#pragma once

#include <array>
#include <cstddef>

#include "bench/integrators/lane_block.hpp"
#include "bench/integrators/problem.hpp"

namespace lober::bench {

template <typename Field>
StateOf<Field> state_in(const double (&rows)[Field::dimension][lanes], std::size_t lane) {
  StateOf<Field> state;
  for (std::size_t i = 0; i < state.size(); ++i) state[i] = rows[i][lane];
  return state;
}

/// Control: whether a lane got a trajectory (begin) or goes on (judge), by what is in that lane only.
template <typename Method, typename Field, typename Control>
void run_lanes(const Field& field, LaneBlock<Field::dimension>& block, Control& control) {
  const StepFunction<Field> steps = step_function<Method, Field>();
  std::array<bool, lanes> live{};
  std::size_t count = 0;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    live[lane] = control.begin(block, lane);
    count += live[lane] ? 1 : 0;
    if (!live[lane]) control.idle(block, lane);
  }
  while (count > 0) {
    steps(field, block);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      if (!live[lane] || control.judge(block, lane) || control.begin(block, lane)) continue;
      live[lane] = false;
      --count;
      control.idle(block, lane);
    }
  }
}

}  // namespace lober::bench
