// Trajectories of an autonomous field over a span of time.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>

#include "bench/integrators/lane_run.hpp"

namespace lober::bench {

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

}  // namespace lober::bench
