// Body of approach_crossings (kernels/all.inl). A lane takes the next pair as soon as its own has stopped.
#pragma once

#include "kernels/smooth_approach.hpp"
#include "kernels/smooth_segment.inl"

namespace lober::detail {
namespace {

struct RunnerLanes {
  Values f[5], chord_x, chord_y, vertex_x, vertex_y, u;
  // At the parameters.
  Values x, y, along_x, along_y;

  LOBER_INLINE void enter(std::size_t lane, const SmoothApproach::Runner& runner, const SmoothSegment& shape) {
    for (std::size_t k = 0; k < 5; ++k) f[k][lane] = shape.f[k + 1];
    chord_x[lane] = shape.chord.x;
    chord_y[lane] = shape.chord.y;
    vertex_x[lane] = runner.vertex.x;
    vertex_y[lane] = runner.vertex.y;
    u[lane] = runner.u;
  }
  LOBER_INLINE void evaluate() {
    const Values slope =
        f[0] + u * (all_of(2) * f[1] + u * (all_of(3) * f[2] + u * (all_of(4) * f[3] + u * all_of(5) * f[4])));
    const Values height = u * (f[0] + u * (f[1] + u * (f[2] + u * (f[3] + u * f[4]))));
    x = vertex_x + (u * chord_x - height * chord_y);
    y = vertex_y + (u * chord_y + height * chord_x);
    along_x = chord_x - slope * chord_y;
    along_y = chord_y + slope * chord_x;
  }
  LOBER_INLINE ValueMask move(Values step) {
    u += greater(all_of(-1), step > all_of(1) ? all_of(1) : step);
    return (u < all_of(-SmoothApproach::slack)) | (u > all_of(1 + SmoothApproach::slack));
  }
};

inline void approach_all(SmoothApproach* pairs, std::size_t count, const SmoothSegment* shapes1,
                         const SmoothSegment* shapes2) {
  using State = SmoothApproach::State;
  RunnerLanes one{}, two{};
  Values sense{}, steps{};
  std::size_t own[fit_lanes], next = 0;
  unsigned running = 0;
  const auto start_next = [&](std::size_t lane) {
    running &= ~(1U << lane);
    if (next == count) return;
    const SmoothApproach& pair = pairs[next];
    one.enter(lane, pair.on1, shapes1[pair.on1.shape]);
    two.enter(lane, pair.on2, shapes2[pair.on2.shape]);
    sense[lane] = pair.rightward_to_left ? 1 : -1;
    steps[lane] = pair.steps_left;
    own[lane] = next++;
    running |= 1U << lane;
  };
  for (std::size_t lane = 0; lane < fit_lanes; ++lane) start_next(lane);
  while (running != 0) {
    one.evaluate();
    two.evaluate();
    const Values apart_x = two.x - one.x, apart_y = two.y - one.y;
    const Values sine = one.along_x * two.along_y - one.along_y * two.along_x;
    const Values step1 = (apart_x * two.along_y - apart_y * two.along_x) / sine;
    const Values step2 = (apart_x * one.along_y - apart_y * one.along_x) / sine;
    const Values small_step = all_of(SmoothApproach::small_step);
    const ValueMask away = ~(sine * sense > all_of(0));
    const ValueMask outside = one.move(step1) | two.move(step2);
    const ValueMask small = (magnitude_of(step1) < small_step) & (magnitude_of(step2) < small_step);
    steps -= all_of(1);
    unsigned stopped = bits_of(away | outside | small | (steps <= all_of(0))) & running;
    if (stopped == 0) continue;
    const unsigned all_away = bits_of(away), all_outside = bits_of(outside), all_small = bits_of(small);
    for (; stopped != 0; stopped &= stopped - 1) {
      const auto lane = static_cast<std::size_t>(__builtin_ctz(stopped));
      const auto has = [&](unsigned bits) { return (bits >> lane & 1U) != 0; };
      SmoothApproach& pair = pairs[own[lane]];
      pair.on1.u = one.u[lane];
      pair.on2.u = two.u[lane];
      pair.steps_left = static_cast<std::int32_t>(steps[lane]);
      pair.small = has(all_small);
      pair.state = has(all_away)      ? State::away
                   : has(all_outside) ? State::outside
                   : pair.small       ? State::met
                                      : State::tired;
      start_next(lane);
    }
  }
}

}  // namespace
}  // namespace lober::detail
