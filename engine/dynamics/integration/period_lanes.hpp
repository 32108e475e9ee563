// Trajectories of a time-periodic field over whole periods.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/dynamics/integration/forcing_table.hpp"
#include "engine/dynamics/integration/lane_queue.hpp"
#include "engine/dynamics/integration/step_control.hpp"

namespace lober::detail {

/// Steps are period / 2^level and begin at whole multiples of themselves, so that the forcing is tabulated; each
/// trajectory has its own level, by its own errors. Queue:
///   bool next(std::size_t& item, double* state);     the next trajectory; false: none left
///   bool arrived(std::size_t item, double* state);   after a period, or half of it; true: another one, from `state`
///   void lost(std::size_t item);
template <typename Rhs, typename Field, typename Queue>
class PeriodLanes {
 public:
  /// `forward`: the direction of time, +1 or -1. `halves`: the halves of a period that a trajectory is followed for, 1
  /// or 2.
  PeriodLanes(const Rhs& rhs, const ForcingTable<Field>& table, const IntegrationOptions& options, int guarded,
              int forward, int halves, Queue& queue)
      : rhs_(rhs),
        table_(table),
        options_(options),
        guarded_(guarded),
        forward_(forward),
        halves_(halves),
        queue_(queue) {
    for (int level = 0; level <= deepest_level; ++level) steps_[level] = std::ldexp(forward * table.period(), -level);
  }

  bool begin(StepBlock<Rhs::size>& block, std::size_t lane) {
    Lane& here = lanes_[lane];
    double state[Rhs::size];
    if (!queue_.next(here.item, state)) return false;
    start(block, lane, state);
    return true;
  }

  bool judge(StepBlock<Rhs::size>& block, std::size_t lane) {
    Lane& here = lanes_[lane];
    const double error = block.error[lane];
    if (++here.tries > options_.max_steps) return lost(here);
    if (!(error <= 1)) {
      measure_noise(rhs_, block, lane, ++here.refusals);
      ++here.level;
      here.position *= 2;
      if (here.level > deepest_level) return lost(here);
      set_step(block, lane);
      return true;
    }
    if (!end_in_bounds(block, lane, guarded_, options_.escape)) return lost(here);
    double state[Rhs::size];
    for (int i = 0; i < Rhs::size; ++i) block.x[i][lane] = state[i] = block.end[i][lane];
    widen_scales<Rhs>(block, lane);
    here.refusals = 0;
    ++here.position;
    // Half a period ends between steps, as these are no longer than it: level 1 at least.
    if (2 * here.position == std::int64_t{halves_} << here.level) {
      if (!queue_.arrived(here.item, state)) return false;
      start(block, lane, state);
      return true;
    }
    if (here.position % 2 == 0 && may_double(error)) {
      --here.level;
      here.position /= 2;
    }
    set_step(block, lane);
    return true;
  }

  void move(StepBlock<Rhs::size>& block, std::size_t from, std::size_t to) {
    lanes_[to] = lanes_[from];
    set_step(block, to);
  }

 private:
  struct Lane {
    std::size_t item = 0;
    std::int64_t position = 0;
    int level = 0;
    int tries = 0;
    int refusals = 0;  // refusals of the present step
  };
  /// Where a trajectory begins: coarse steps are tried first, and cost one try for each level that they are too long.
  static constexpr int first_level = 3;
  /// Shorter steps would not change the time of 1 + 2^-53 periods.
  static constexpr int deepest_level = 52;

  void start(StepBlock<Rhs::size>& block, std::size_t lane, const double* state) {
    Lane& here = lanes_[lane];
    for (int i = 0; i < Rhs::size; ++i) block.x[i][lane] = state[i];
    here.position = 0;
    here.level = first_level;
    here.tries = here.refusals = 0;
    begin_scales(rhs_, block, lane, state, guarded_);
    set_step(block, lane);
  }

  void set_step(StepBlock<Rhs::size>& block, std::size_t lane) {
    const Lane& here = lanes_[lane];
    block.h[lane] = steps_[here.level];
    block.forcing[lane] = table_.record(forward_, here.level, here.position, own_[lane]);
  }

  bool lost(const Lane& here) {
    queue_.lost(here.item);
    return false;
  }

  const Rhs& rhs_;
  const ForcingTable<Field>& table_;
  const IntegrationOptions& options_;
  int guarded_;
  int forward_;
  int halves_;
  Queue& queue_;
  double steps_[deepest_level + 1];  // by level
  Lane lanes_[block_lanes];
  double own_[block_lanes][ForcingTable<Field>::record_size]{};
};

}  // namespace lober::detail
