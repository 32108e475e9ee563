// Trajectories taken from a queue, as many at a time as a block of steps holds.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/dynamics/integration/lane_steps.hpp"
#include "lober/base/cancellation.hpp"

namespace lober::detail {

/// The number of arrivals still due for each trajectory of a queue.
class Arrivals {
 public:
  Arrivals(int each, std::size_t trajectories) : each_(each), left_(each > 1 ? trajectories : 0) {}
  void begin(std::size_t item) {
    if (each_ > 1) left_[item] = each_;
  }
  /// After an arrival: whether it goes on.
  bool again(std::size_t item) { return each_ > 1 && --left_[item] > 0; }

 private:
  int each_;
  std::vector<int> left_;
};

/// A queue of one trajectory, for PeriodLanes and the like.
template <int size>
struct SingleTrajectory {
  double (&state)[size];  ///< where it begins, then where it has arrived
  double time = 0;        ///< time of the arrival at a section
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

/// Judges the steps of the first `live` lanes (run_lanes), and fills lanes whose trajectory has ended.
template <int size, typename Control>
void judge_lanes(StepBlock<size>& block, Control& control, std::size_t& live) {
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

/// Returns how many steps were computed. Control decides about them, one lane at a time and by what is in that lane
/// only, so that a trajectory has the same bits whatever runs beside it. Throws Cancelled.
///
///   bool begin(block, lane);      takes the next trajectory and sets its first step; false: none is left
///
///   bool judge(block, lane);      after a step; sets the next one; false: the trajectory has ended
///
///   void move(block, from, to);   all that it knows of a lane; the block's part has moved, but for forcing
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
    judge_lanes(block, control, live);
  }
  return computed;
}

}  // namespace lober::detail
