// Trajectories taken from a queue, as many at a time as a block of steps holds.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "engine/dynamics/integration/lane_steps.hpp"
#include "lober/cancellation.hpp"

namespace lober::detail {

/// A queue of one trajectory, for PeriodLanes and the like.
template <int size>
struct SingleTrajectory {
  double (&state)[size];  ///< where it begins, then where it has arrived
  double time = 0;        ///< of the arrival at a section
  bool begun = false;
  bool found = false;  ///< whether it has arrived

  bool next(std::size_t& item, double* start) {
    if (begun) return false;
    begun = true;
    item = 0;
    std::copy_n(state, size, start);
    return true;
  }
  bool arrived(std::size_t /*item*/, const double* end, double at = 0) {
    std::copy_n(end, size, state);
    time = at;
    found = true;
    return false;
  }
  void lost(std::size_t /*item*/) {}
};

/// Control decides about steps, one lane at a time and by what is in that lane only, so that a trajectory has the same
/// bits whatever runs beside it:
///   bool begin(block, lane);           takes the next trajectory into the lane and sets its first step; false: none
///   left bool judge(block, lane);           after a step; sets the next one. False: the trajectory has ended void
///   move(block, from, to);        what the control knows of a lane; the block's part has moved, but for forcing
/// Returns how many steps were computed. Throws Cancelled.
template <typename Rhs, typename Control>
std::uint64_t run_lanes(const Rhs& rhs, StepBlock<Rhs::size>& block, StepFunction<Rhs> steps, Control& control) {
  std::uint64_t computed = 0;
  std::size_t live = 0;
  while (live < block_lanes && control.begin(block, live)) ++live;
  // Vectors are computed whole: lanes that nobody uses hold something that can be computed.
  for (std::size_t lane = live; live > 0 && lane < block_lanes; ++lane) {
    block.copy_lane(0, lane);
    block.forcing[lane] = block.forcing[0];
  }
  while (live > 0) {
    throw_if_cancelled();
    steps(rhs, block, live);
    computed += live;
    for (std::size_t lane = 0; lane < live;) {
      if (control.judge(block, lane) || control.begin(block, lane)) {
        ++lane;
        continue;
      }
      // The last one takes the place of the one that ended.
      --live;
      if (lane == live) break;
      block.copy_lane(live, lane);
      control.move(block, live, lane);
    }
  }
  return computed;
}

}  // namespace lober::detail
