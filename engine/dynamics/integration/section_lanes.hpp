// Trajectories of an autonomous field to where they cross a section.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "engine/dynamics/integration/lane_queue.hpp"
#include "engine/dynamics/integration/step_control.hpp"
#include "engine/dynamics/integration/wide_steps.hpp"
#include "lober/dynamics/flow.hpp"

namespace lober::detail {

/// Each trajectory has its own steps. A crossing is located on the step that holds it, by steps of other lengths from
/// where that step begins. The state begins with the coordinates of phase space. Queue:
///   bool next(std::size_t& item, double* state);      the next trajectory; false: none left
///   bool arrived(std::size_t item, double* state, double time);   at a crossing that counts, the section's coordinate
///                                                     exactly at its value; true: on to the next one, from `state`
///   void lost(std::size_t item);
template <typename Rhs, typename Queue>
class SectionLanes {
  static constexpr int size = Rhs::size;
  static constexpr int inner = 2 * step_columns - 1;

 public:
  /// `forward`: the direction of time, +1 or -1.
  SectionLanes(const Rhs& rhs, const Section& section, const IntegrationOptions& options, int guarded, int forward,
               Queue& queue)
      : rhs_(rhs),
        section_(section),
        axis_(section.coordinate),
        options_(options),
        guarded_(guarded),
        forward_(forward),
        queue_(queue) {
    probe_.tolerance = options.tolerance;
  }

  bool begin(StepBlock<size>& block, std::size_t lane) {
    double state[size];
    while (queue_.next(lanes_[lane].item, state)) {
      if (start(block, lane, state)) return true;
    }
    return false;
  }

  bool judge(StepBlock<size>& block, std::size_t lane) {
    Lane& here = lanes_[lane];
    return here.locating ? located(block, lane) : followed(block, lane);
  }

  void move(StepBlock<size>& /*block*/, std::size_t from, std::size_t to) { lanes_[to] = lanes_[from]; }

 private:
  /// A part of a step within which the trajectory leaves `side` of the section.
  struct Bracket {
    double begin = 0, end = 0, side = 0;
    double guess = 0;
  };
  struct Lane {
    std::size_t item = 0;
    double t = 0;
    double h = 0;      // as long as errors allow
    double level = 0;  // value of the coordinate on the section: one of them, where it is an angle
    double side = 0;   // side of the section where the step begins; only the sign matters
    int tries = 0;
    int refusals = 0;  // refusals of the present step
    bool locating = false;
    // While a crossing is located:
    Bracket bracket, next;  // next.side is 0 if there is no second one
    double s = 0;           // time since the step's begin
    int rounds = 0;
    double step = 0;  // its length
    double end[size]{};
  };

  [[nodiscard]] static double off(const Lane& here, double coordinate) { return coordinate - here.level; }

  // The value nearest to the coordinate among those at which an angle is on the section.
  [[nodiscard]] double nearest_level(double coordinate) const {
    if (section_.period == 0) return section_.value;
    return section_.value + section_.period * std::floor((coordinate - section_.value) / section_.period + 0.5);
  }

  // On a step from `begin` to `end`, shorter than half a period, at most one of those values lies between them.
  void choose_level(Lane& here, double begin, double end) const {
    if (section_.period == 0) return;
    const auto passed = [&](double level) { return (begin - level) * (end - level) <= 0; };
    double level = nearest_level(begin);
    if (begin != level && !passed(level)) {
      const double last = nearest_level(end);
      level = passed(last) ? last : nearest_level(0.5 * (begin + end));
    }
    if (level == here.level) return;
    here.level = level;
    here.side = begin - level;
  }

  // False: the trajectory is lost at once.
  bool start(StepBlock<size>& block, std::size_t lane, const double* state) {
    Lane& here = lanes_[lane];
    double slope[size];
    rhs_(state, slope, state);  // there is no forcing
    for (int i = 0; i < size; ++i) block.x[i][lane] = state[i];
    here.t = 0;
    here.tries = here.refusals = 0;
    begin_scales(rhs_, block, lane, state, guarded_);
    here.locating = false;
    here.level = nearest_level(state[axis_]);
    here.side = off(here, state[axis_]);
    if (here.side == 0) here.side = forward_ * slope[axis_];
    here.h = forward_ * first_step(rhs_, state, slope, guarded_, options_.tolerance, 1e-3 * options_.max_time);
    if (here.side == 0 || std::isnan(here.side)) {  // along the section
      queue_.lost(here.item);
      return false;
    }
    set_step(block, lane);
    return true;
  }

  void set_step(StepBlock<size>& block, std::size_t lane) {
    const double rest = forward_ * options_.max_time - lanes_[lane].t;
    block.h[lane] = std::abs(rest) < std::abs(lanes_[lane].h) ? rest : lanes_[lane].h;
  }

  bool followed(StepBlock<size>& block, std::size_t lane) {
    Lane& here = lanes_[lane];
    const double error = block.error[lane], h = block.h[lane];
    if (++here.tries > options_.max_steps) return lost(here);
    here.h = h * step_factor(error);
    if (!(error <= 1)) {
      measure_noise(rhs_, block, lane, ++here.refusals);
      if (here.t + here.h == here.t) return lost(here);
      set_step(block, lane);
      return true;
    }
    if (!end_in_bounds(block, lane, guarded_, options_.escape)) return lost(here);
    const double begin = block.x[axis_][lane], end = block.end[axis_][lane];
    if (section_.period > 0 && std::abs(end - begin) >= 0.5 * section_.period) {
      here.h = 0.5 * h;
      set_step(block, lane);
      return true;
    }
    here.refusals = 0;
    choose_level(here, begin, end);
    here.step = h;
    for (int i = 0; i < size; ++i) here.end[i] = block.end[i][lane];
    find_brackets(block, lane);
    return next_bracket(block, lane);
  }

  // Finds where the section is crossed on the last step.
  void find_brackets(const StepBlock<size>& block, std::size_t lane) {
    Lane& here = lanes_[lane];
    const double h = here.step, x = off(here, block.x[axis_][lane]), at_end = off(here, block.end[axis_][lane]);
    here.bracket.side = here.next.side = 0;
    double values[inner + 2];
    values[0] = x;
    for (int k = 0; k < inner; ++k) values[k + 1] = x + block.way[k][axis_][lane];
    values[inner + 1] = at_end;
    int across = 1;
    while (across <= inner && values[across] * here.side > 0) ++across;
    if (at_end * here.side <= 0) {
      here.bracket = {0, h, here.side, guess(values, across, h)};
      return;
    }
    const std::optional<double> beyond = excursion(block, lane, across <= inner ? across : 0);
    if (!beyond) return;
    here.bracket = {0, *beyond, here.side, 0.5 * *beyond};
    here.next = {*beyond, h, -here.side, 0.5 * (*beyond + h)};
  }

  // A guess by the straight line through the values around the first one that is across.
  [[nodiscard]] static double guess(const double* values, int across, double h) {
    const double part = h / (inner + 1), a = values[across - 1], b = values[across];
    const double share = a / (a - b);
    return part * (across - 1 + (share > 0 && share < 1 ? share : 0.5));
  }

  // Begins to locate the crossing of the lane's bracket, or of the next one, or goes on beyond the step.
  bool next_bracket(StepBlock<size>& block, std::size_t lane) {
    Lane& here = lanes_[lane];
    while (here.bracket.side != 0) {
      const bool counts = section_.direction == 0 || -here.bracket.side * forward_ * section_.direction > 0;
      if (counts) {
        here.locating = true;
        here.rounds = 0;
        here.s = here.bracket.guess;
        block.h[lane] = here.s;
        return true;
      }
      here.bracket = here.next;
      here.next.side = 0;
    }
    here.locating = false;
    for (int i = 0; i < size; ++i) block.x[i][lane] = here.end[i];
    widen_scales<Rhs>(block, lane);
    here.t += here.step;
    if (std::abs(here.t) >= options_.max_time) return lost(here);
    const double value = off(here, here.end[axis_]);
    here.side = value != 0 ? value : forward_ * end_slope(here);
    set_step(block, lane);
    return true;
  }

  // After a step of length `s`: Newton's method, and bisection where it would leave the bracket.
  bool located(StepBlock<size>& block, std::size_t lane) {
    Lane& here = lanes_[lane];
    Bracket& bracket = here.bracket;
    const double value = off(here, block.end[axis_][lane]);
    double next = here.s - value / block.end_slope[axis_][lane];
    bool done = value == 0 || next == here.s || !std::isfinite(value) || ++here.rounds == 60;
    if (!done) {
      (value * bracket.side > 0 ? bracket.begin : bracket.end) = here.s;
      const auto [low, high] = std::minmax(bracket.begin, bracket.end);
      if (!(low <= next && next <= high)) next = 0.5 * (bracket.begin + bracket.end);
      done = std::abs(next - here.s) <= 1e-15 * std::abs(here.step);
    }
    if (!done) {
      here.s = next;
      block.h[lane] = next;
      return true;
    }
    double state[size];
    for (int i = 0; i < size; ++i) state[i] = block.end[i][lane];
    state[axis_] = section_.value;
    if (section_.bound_side == 0 || section_.bound_side * (state[section_.bound_coordinate] - section_.bound) >= 0) {
      return queue_.arrived(here.item, state, here.t + here.s) && start(block, lane, state);
    }
    bracket = here.next;
    here.next.side = 0;
    return next_bracket(block, lane);
  }

  bool lost(const Lane& here) {
    queue_.lost(here.item);
    return false;
  }

  // The rest is for steps that begin and end on the same side, and is seldom needed.

  /// A time within the step at which the trajectory is on the other side. `seen`: at which of the inner points it seems
  /// to be; 0: at none.
  std::optional<double> excursion(const StepBlock<size>& block, std::size_t lane, int seen) {
    const Lane& here = lanes_[lane];
    const double h = here.step, side = here.side;
    double a = 0, b = h, slope_a = block.slope[axis_][lane], slope_b = block.end_slope[axis_][lane];
    if (seen == 0 && (side * slope_a * h >= 0 || side * slope_b * h <= 0)) return std::nullopt;
    for (int i = 0; i < size; ++i) probe_.x[i][0] = block.x[i][lane];
    if (seen != 0) {
      // The turning point is between the inner points beside the lowest one.
      int lowest = seen;
      for (int k = seen; k <= inner; ++k) {
        if (block.way[k - 1][axis_][lane] * side < block.way[lowest - 1][axis_][lane] * side) lowest = k;
      }
      const double part = h / (inner + 1);
      if (probe(here, part * lowest) * side <= 0) return part * lowest;
      a = part * (lowest - 1);
      b = part * (lowest + 1);
      if (lowest > 1 && probe(here, a) * side <= 0) return a;
      slope_a = lowest > 1 ? probe_.end_slope[axis_][0] : slope_a;
      if (lowest < inner && probe(here, b) * side <= 0) return b;
      slope_b = lowest < inner ? probe_.end_slope[axis_][0] : slope_b;
      if (side * slope_a * h >= 0 || side * slope_b * h <= 0) return std::nullopt;
    }
    // Uses regula falsi and bisection on the slope of the true trajectory.
    for (int k = 0; k < 60; ++k) {
      double s = k % 3 == 2 ? 0.5 * (a + b) : a - slope_a * (b - a) / (slope_b - slope_a);
      if (!(std::min(a, b) < s && s < std::max(a, b))) s = 0.5 * (a + b);
      const double value = probe(here, s), slope = probe_.end_slope[axis_][0];
      if (value * side <= 0) return s;
      // The rest of the way down, if the slope stayed the largest seen.
      const double steepest = std::max(std::abs(slope_a), std::abs(slope_b));
      (slope * slope_a > 0 ? a : b) = s;
      (slope * slope_a > 0 ? slope_a : slope_b) = slope;
      if (std::abs(value) > steepest * std::abs(b - a) || std::abs(b - a) <= 1e-13 * std::abs(h)) break;
    }
    return std::nullopt;
  }

  /// The distance from the section at which a step of length s ends; its slope is then in probe_.
  double probe(const Lane& here, double s) {
    probe_.h[0] = s;
    single_step(rhs_, probe_);
    return off(here, probe_.end[axis_][0]);
  }

  double end_slope(const Lane& here) const {
    double slope[size];
    rhs_(here.end, slope, here.end);
    return slope[axis_];
  }

  const Rhs& rhs_;
  const Section& section_;
  int axis_;
  const IntegrationOptions& options_;
  int guarded_;
  int forward_;
  Queue& queue_;
  Lane lanes_[block_lanes];
  StepBlock<size> probe_{};
};

}  // namespace lober::detail
