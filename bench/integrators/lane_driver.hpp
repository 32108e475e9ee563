// Trajectories in lanes by any method: the same driver for all of them, that of engine/dynamics/integration in short.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <vector>

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

/// Steps of period / 2^level that begin at whole multiples of themselves, with the forcing tabulated for each.
template <typename Method, typename Field>
class PeriodRun {
  static constexpr int first_level = 3, deepest_level = 13;

 public:
  explicit PeriodRun(const Problem<Field>& problem) : field_(problem.field), period_(problem.span) {
    for (int e = StepFactors::lowest; e <= StepFactors::highest; ++e) {
      const int halvings = e <= 0 ? 0 : (e + Method::error_power - 1) / Method::error_power;
      factors_.of[e - StepFactors::lowest] = std::ldexp(1, -halvings);
    }
  }

  void operator()(double tolerance, std::span<StateOf<Field>> points) {
    points_ = points;
    next_ = 0;
    LaneBlock<Field::dimension> block{};
    block.tolerance = tolerance;
    block.factors = &factors_;
    run_lanes<Method>(field_, block, *this);
  }

  bool begin(LaneBlock<Field::dimension>& block, std::size_t lane) {
    if (next_ == points_.size()) return false;
    start(block, lane, next_++);
    return true;
  }
  /// Lanes that nobody uses hold something that can be computed.
  void idle(LaneBlock<Field::dimension>& block, std::size_t lane) { start(block, lane, 0); }

  bool judge(LaneBlock<Field::dimension>& block, std::size_t lane) {
    Lane& here = lanes_[lane];
    const double error = block.error[lane];
    const bool whole = !Method::chooses || block.taken[lane] == 1;
    if (!(error <= 1) || !whole) {
      const int halvings = error <= 1 ? -std::ilogb(block.taken[lane]) : 1;
      here.level += halvings;
      here.position <<= halvings;
      if (here.level > deepest_level) throw std::runtime_error("steps become too short");
    }
    if (error <= 1) {
      const StateOf<Field> end = state_in<Field>(block.end, lane);
      for (std::size_t i = 0; i < end.size(); ++i) block.x[i][lane] = end[i];
      ++here.position;
      if (here.position == std::int64_t{1} << here.level) {
        points_[here.point] = end;
        return false;
      }
      // With half of the allowed error to spare. A method that chooses takes as much of the step as it can.
      constexpr double limit = 1.0 / (std::uint64_t{1} << static_cast<unsigned>(Method::error_power + 1));
      if (here.position % 2 == 0 && whole && here.level > 0 && error < limit) {
        --here.level;
        here.position /= 2;
      }
    }
    set_step(block, lane);
    return true;
  }

 private:
  struct Lane {
    std::size_t point = 0;
    std::int64_t position = 0;
    int level = 0;
  };

  void start(LaneBlock<Field::dimension>& block, std::size_t lane, std::size_t point) {
    lanes_[lane] = {point, 0, first_level};
    for (std::size_t i = 0; i < points_[point].size(); ++i) block.x[i][lane] = points_[point][i];
    set_step(block, lane);
  }

  void set_step(LaneBlock<Field::dimension>& block, std::size_t lane) {
    const Lane& here = lanes_[lane];
    block.h[lane] = std::ldexp(period_, -here.level);
    block.limit[lane] = 1;
    block.forcing[lane] = table(here.level).data() + static_cast<std::size_t>(here.position) * record_size;
  }

  const std::vector<double>& table(int level) {
    std::vector<double>& records = tables_[static_cast<std::size_t>(level)];
    if (records.empty()) {
      const double h = std::ldexp(period_, -level);
      records.resize((std::size_t{1} << static_cast<unsigned>(level)) * record_size);
      for (std::size_t k = 0; k * record_size < records.size(); ++k) {
        Method::tabulate(field_, static_cast<double>(k) * h, h, records.data() + k * record_size);
      }
    }
    return records;
  }

  static constexpr std::size_t record_size = Method::template record_size<Field>;
  const Field& field_;
  double period_;
  StepFactors factors_;
  std::array<std::vector<double>, deepest_level + 1> tables_;
  std::span<StateOf<Field>> points_;
  std::size_t next_ = 0;
  Lane lanes_[lanes];
};

/// Steps of any length of an autonomous field.
template <typename Method, typename Field>
class SpanRun {
 public:
  explicit SpanRun(const Problem<Field>& problem) : field_(problem.field), span_(problem.span) {
    for (int e = StepFactors::lowest; e <= StepFactors::highest; ++e) {
      // The step of a method that chooses is as long as its series says; others should not trust one estimate so far.
      const double factor = 0.95 * std::exp2(-static_cast<double>(e) / Method::error_power);
      factors_.of[e - StepFactors::lowest] = Method::chooses ? factor : std::clamp(factor, 0.125, 4.0);
    }
  }

  void operator()(double tolerance, std::span<StateOf<Field>> points) {
    points_ = points;
    next_ = 0;
    tolerance_ = tolerance;
    LaneBlock<Field::dimension> block{};
    block.tolerance = tolerance;
    block.factors = &factors_;
    run_lanes<Method>(field_, block, *this);
  }

  bool begin(LaneBlock<Field::dimension>& block, std::size_t lane) {
    if (next_ == points_.size()) return false;
    start(block, lane, next_++);
    return true;
  }
  void idle(LaneBlock<Field::dimension>& block, std::size_t lane) { start(block, lane, 0); }

  bool judge(LaneBlock<Field::dimension>& block, std::size_t lane) {
    Lane& here = lanes_[lane];
    const double error = block.error[lane], h = block.h[lane];
    if (!(error <= 1)) {
      here.h = h * factor(error);
      if (here.t + here.h == here.t) throw std::runtime_error("steps become too short");
      set_step(block, lane);
      return true;
    }
    const StateOf<Field> end = state_in<Field>(block.end, lane);
    for (std::size_t i = 0; i < end.size(); ++i) block.x[i][lane] = end[i];
    if (Method::chooses ? block.taken[lane] == block.limit[lane] : here.last) {
      points_[here.point] = end;
      return false;
    }
    if constexpr (Method::chooses) {
      here.h = h * block.taken[lane];
      here.t += here.h;
    } else {
      here.t += h;
      // A step cut short says little about the next one.
      const double proposed = h * factor(error);
      if (h == here.h || proposed > here.h) here.h = proposed;
    }
    set_step(block, lane);
    return true;
  }

 private:
  struct Lane {
    std::size_t point = 0;
    double t = 0, h = 0;
    bool last = false;
  };

  double factor(double error) const {
    if (!std::isfinite(error)) return 0.125;
    const int exponent = error > 0 ? std::ilogb(error) + 1 : StepFactors::lowest;
    return factors_.of[std::clamp(exponent, StepFactors::lowest, StepFactors::highest) - StepFactors::lowest];
  }

  void start(LaneBlock<Field::dimension>& block, std::size_t lane, std::size_t point) {
    const StateOf<Field>& x = points_[point];
    StateOf<Field> slope;
    field_.velocity(x.data(), slope.data(), x.data());  // there is no forcing
    double size = 0, speed = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      size = std::max(size, std::abs(x[i]));
      speed = std::max(speed, std::abs(slope[i]));
      block.x[i][lane] = x[i];
    }
    const double first = std::pow(tolerance_, 1.0 / Method::error_power) * (1 + size) / std::max(speed, 1e-3);
    lanes_[lane] = {point, 0, std::min(first, span_), false};
    set_step(block, lane);
  }

  void set_step(LaneBlock<Field::dimension>& block, std::size_t lane) {
    Lane& here = lanes_[lane];
    const double rest = span_ - here.t;
    if constexpr (Method::chooses) {
      block.h[lane] = here.h;
      block.limit[lane] = rest / here.h;
    } else {
      here.last = rest <= here.h;
      // The last two steps share what is left, so that none is a mere remainder.
      block.h[lane] = here.last ? rest : rest < 2 * here.h ? 0.5 * rest : here.h;
    }
  }

  const Field& field_;
  double span_;
  double tolerance_ = 0;
  StepFactors factors_;
  std::span<StateOf<Field>> points_;
  std::size_t next_ = 0;
  Lane lanes_[lanes];
};

template <typename Method, typename Field>
Integration<Field> in_lanes(const Problem<Field>& problem) {
  using Run = std::conditional_t<Field::forcings == 0, SpanRun<Method, Field>, PeriodRun<Method, Field>>;
  // Shared, so that tables are computed once.
  return [run = std::make_shared<Run>(problem)](double tolerance, std::span<StateOf<Field>> points) {
    (*run)(tolerance, points);
  };
}

}  // namespace lober::bench
