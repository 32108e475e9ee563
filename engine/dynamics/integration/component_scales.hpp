// The sizes by which the errors of a trajectory are judged, where coordinates may be in any unit. A trajectory that
// begins with a coordinate of the order of the field's unit or more has that scale for all of them, as those of the
// built-in systems have 1. One that begins with smaller coordinates only, as those of molecules are in SI units where
// no window says so, has for each component the largest size that it has had so far: that is known from the trajectory
// alone, whatever is integrated beside it.
//
// A coordinate that is zero but for rounding, as on an invariant axis, has no size of its own; errors below the
// rounding of its velocity are then asked for, and no step meets that. So where a step is refused again and again, the
// rounding of the velocity is measured, and counts as allowed error.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "engine/dynamics/integration/step_block.hpp"
#include "kernels/elementary.hpp"
#include "lober/dynamics/flow.hpp"

namespace lober::detail {

/// A component of size 0 with an error of 0 is right, and 0 / 0 would not be.
inline constexpr double least_scale = 1e-280;
/// Refusals of one step after which rounding is measured: seldom, since that may be a call that costs much.
inline constexpr int refusals_before_noise = 5;

/// Whether a state has a coordinate, among the first `guarded` components, of the order of the unit or more.
inline bool has_large_coordinate(const double* x, int guarded, double unit) {
  constexpr double large = 1e-2;
  return std::any_of(x, x + guarded, [unit](double value) { return std::abs(value) >= large * unit; });
}

/// At the start of a trajectory, whose state is in the block too. A component after the coordinates is one of a tangent
/// vector, which has no unit, or the action, an area.
template <typename Rhs>
void begin_scales(const Rhs& rhs, StepBlock<Rhs::size>& block, std::size_t lane, const double* state, int guarded) {
  if constexpr (Rhs::own_units) {
    const double unit = rhs.field.unit();
    block.widens[lane] = !has_large_coordinate(state, guarded, unit);
    for (int i = 0; i < Rhs::size; ++i) {
      const double known = i < guarded ? unit : Rhs::size == guarded + 1 ? unit * unit : 1;
      block.scale[i][lane] = block.widens[lane] ? std::max(std::abs(state[i]), least_scale) : known;
      block.noise[i][lane] = 0;
    }
  }
}

/// After a step that is taken, when the block has the new state.
template <typename Rhs>
void widen_scales(StepBlock<Rhs::size>& block, std::size_t lane) {
  if constexpr (Rhs::own_units) {
    if (!block.widens[lane]) return;  // |x| counts beside it
    for (int i = 0; i < Rhs::size; ++i) {
      block.scale[i][lane] = std::max(block.scale[i][lane], std::abs(block.x[i][lane]));
    }
  }
}

/// After the refusal of a step, number `refusals` in a row.
template <typename Rhs>
void measure_noise(const Rhs& rhs, StepBlock<Rhs::size>& block, std::size_t lane, int refusals) {
  if constexpr (Rhs::own_units) {
    if (refusals < refusals_before_noise) return;
    // The velocity changes by several units in the last place of the state, in other directions each time.
    constexpr double some_ulps = 0x1p-50;
    double at[Rhs::size], speed[Rhs::size];
    for (int i = 0; i < Rhs::size; ++i) {
      const double sign = ((refusals >> (i % 3)) & 1) != 0 ? 1 : -1;
      const double size = std::abs(block.x[i][lane]) + std::abs(block.h[lane] * block.slope[i][lane]);
      at[i] = block.x[i][lane] + sign * some_ulps * size;
    }
    rhs(at, speed, block.forcing[lane]);
    for (int i = 0; i < Rhs::size; ++i) {
      const double changed = std::abs(speed[i] - block.slope[i][lane]);
      // Not the largest so far: steps that were far too long have passed by other parts of the field. The errors of the
      // columns of a step add up to some times that of one velocity.
      if (changed < std::numeric_limits<double>::infinity()) block.noise[i][lane] = 8 * changed;
    }
  }
}

/// The first step where units are unknown: on which no coordinate changes by more than the eleventh root of the
/// tolerance of itself, `longest` at most. `root`: that root.
inline double first_step_by_sizes(const double* x, const double* slope, int guarded, double root, double longest) {
  double time = longest;
  for (int k = 0; k < guarded; ++k) {
    if (x[k] != 0 && slope[k] != 0) time = std::min(time, root * std::abs(x[k] / slope[k]));
  }
  return time > 0 ? time : longest;
}

}  // namespace lober::detail
