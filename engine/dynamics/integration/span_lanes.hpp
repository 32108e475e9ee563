// Trajectories between two times.
#pragma once

#include <cmath>
#include <cstddef>

#include "engine/dynamics/integration/forcing_table.hpp"
#include "engine/dynamics/integration/lane_queue.hpp"
#include "engine/dynamics/integration/step_control.hpp"

namespace lober::detail {

/// Each trajectory has its own steps, of any length. Queue:
///   bool next(std::size_t& item, double* state);     the next trajectory; false: none left
///   void arrived(std::size_t item, const double* state);
///   void lost(std::size_t item);
template <typename Rhs, typename Field, typename Queue>
class SpanLanes {
 public:
  SpanLanes(const Rhs& rhs, const Field& field, double from, double to, const IntegrationOptions& options, int guarded,
            Queue& queue)
      : rhs_(rhs), field_(field), from_(from), to_(to), options_(options), guarded_(guarded), queue_(queue) {}

  bool begin(StepBlock<Rhs::size>& block, std::size_t lane) {
    Lane& here = lanes_[lane];
    double state[Rhs::size];
    for (;;) {
      if (!queue_.next(here.item, state)) return false;
      if (from_ != to_) break;
      queue_.arrived(here.item, state);
    }
    double slope[Rhs::size], force[Rhs::forcings + 1];
    if constexpr (Rhs::forcings > 0) field_.forcing(from_, force);
    rhs_(state, slope, force);
    for (int i = 0; i < Rhs::size; ++i) block.x[i][lane] = state[i];
    here.t = from_;
    here.tries = here.refusals = 0;
    begin_scales(rhs_, block, lane, state, guarded_);
    here.h = std::copysign(first_step(rhs_, state, slope, guarded_, options_.tolerance, 0.125 * std::abs(to_ - from_)),
                           to_ - from_);
    set_step(block, lane);
    return true;
  }

  bool judge(StepBlock<Rhs::size>& block, std::size_t lane) {
    Lane& here = lanes_[lane];
    const double error = block.error[lane], h = block.h[lane], proposed = h * step_factor(error);
    if (++here.tries > options_.max_steps) return lost(here);
    if (!(error <= 1)) {
      measure_noise(rhs_, block, lane, ++here.refusals);
      here.h = proposed;
      if (here.t + here.h == here.t) return lost(here);
      set_step(block, lane);
      return true;
    }
    if (!end_in_bounds(block, lane, guarded_, options_.escape)) return lost(here);
    double state[Rhs::size];
    for (int i = 0; i < Rhs::size; ++i) block.x[i][lane] = state[i] = block.end[i][lane];
    widen_scales<Rhs>(block, lane);
    here.refusals = 0;
    if (here.last) {
      queue_.arrived(here.item, state);
      return false;
    }
    here.t += h;
    // A step cut short says little about the next one.
    if (h == here.h || std::abs(proposed) > std::abs(here.h)) here.h = proposed;
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
    double t = 0;
    double h = 0;  // as long as errors allow
    int tries = 0;
    int refusals = 0;  // refusals of the present step
    bool last = false;
  };

  void set_step(StepBlock<Rhs::size>& block, std::size_t lane) {
    Lane& here = lanes_[lane];
    const double rest = to_ - here.t;
    here.last = std::abs(rest) <= std::abs(here.h);
    // The last two steps share the rest, so that none is a mere remainder.
    block.h[lane] = here.last ? rest : std::abs(rest) < 2 * std::abs(here.h) ? 0.5 * rest : here.h;
    if constexpr (Rhs::forcings > 0) tabulate_step(field_, here.t, block.h[lane], own_[lane]);
    block.forcing[lane] = own_[lane];
  }

  bool lost(const Lane& here) {
    queue_.lost(here.item);
    return false;
  }

  const Rhs& rhs_;
  const Field& field_;
  double from_, to_;
  const IntegrationOptions& options_;
  int guarded_;
  Queue& queue_;
  Lane lanes_[block_lanes];
  double own_[block_lanes][step_stages * Rhs::forcings + 1]{};
};

}  // namespace lober::detail
