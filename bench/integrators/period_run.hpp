// Trajectories of a time-periodic field over one period.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

#include "bench/integrators/lane_run.hpp"

namespace lober::bench {

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

}  // namespace lober::bench
