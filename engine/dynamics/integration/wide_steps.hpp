// Steps of thousands of trajectories at once, for fields that are computed for many points at a time.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/dynamics/integration/lane_queue.hpp"

namespace lober::detail {

/// The steps of some lanes of some blocks: the same bits as extrapolation_step, with all columns of all lanes side by
/// side, so that the field is asked twelve times a step, and not 37 times. Rhs: size, forcings, and
///   void many(std::size_t count, const double* x, const double* t, double* dxdt)   coordinate i of point k at
///                                                                                   [i * count + k]
/// forcings is 0, or 1 and then the forcing is the time.
template <typename Rhs>
class WideSteps {
  static_assert(Rhs::own_units);
  static constexpr std::size_t size = Rhs::size;

 public:
  struct Lane {
    StepBlock<Rhs::size>* block;
    std::size_t number;
  };

  void compute(const Rhs& rhs, std::span<const Lane> lanes) {
    const std::size_t count = lanes.size();
    ensure_size(x_, size * count);
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t k = 0; k < count; ++k) x_[i * count + k] = lanes[k].block->x[i][lanes[k].number];
    }
    ensure_size(slope_, size * count);
    times_of_stage(lanes, 0);
    rhs.many(count, x_.data(), t_.data(), slope_.data());
    begin_columns(lanes);
    for (int k = 1; k < substeps_of(step_columns - 1); ++k) advance(rhs, lanes, k);
    finish(rhs, lanes);
  }

 private:
  /// The changes of the state up to the last two substeps of a column.
  struct Column {
    std::vector<double> before, here;
  };

  /// The numbers are lost where there are too few of them.
  static void ensure_size(std::vector<double>& numbers, std::size_t count) {
    if (numbers.size() < count) numbers = std::vector<double>(count);
  }
  [[nodiscard]] static double time(const Lane& lane, std::size_t stage) {
    if constexpr (Rhs::forcings == 0) return 0;
    return lane.block->forcing[lane.number][stage];
  }
  void times_of_stage(std::span<const Lane> lanes, std::size_t stage) {
    ensure_size(t_, lanes.size());
    for (std::size_t k = 0; k < lanes.size(); ++k) t_[k] = time(lanes[k], stage);
  }

  void begin_columns(std::span<const Lane> lanes) {
    const std::size_t count = lanes.size();
    for (int column = 0; column < step_columns; ++column) {
      Column& changed = columns_[column];
      ensure_size(changed.before, size * count);
      std::fill_n(changed.before.begin(), size * count, 0.0);
      ensure_size(changed.here, size * count);
      for (std::size_t k = 0; k < count; ++k) {
        const double substep = lanes[k].block->h[lanes[k].number] * (1.0 / substeps_of(column));
        for (std::size_t i = 0; i < size; ++i) changed.here[i * count + k] = substep * slope_[i * count + k];
      }
    }
  }

  /// Substep k of all columns that have it.
  void advance(const Rhs& rhs, std::span<const Lane> lanes, int substep) {
    const std::size_t count = lanes.size();
    if constexpr (Rhs::forcings == 0) {
      const Column& finest = columns_[step_columns - 1];
      for (std::size_t k = 0; k < count; ++k) {
        for (std::size_t i = 0; i < size; ++i) {
          lanes[k].block->way[substep - 1][i][lanes[k].number] = finest.here[i * count + k];
        }
      }
    }
    int first = 0;
    while (substep >= substeps_of(first)) ++first;
    const auto active = static_cast<std::size_t>(step_columns - first);
    const std::size_t all = active * count;
    ensure_size(at_, size * all);
    ensure_size(speed_, size * all);
    ensure_size(t_, all);
    for (std::size_t a = 0; a < active; ++a) {
      const int column = first + static_cast<int>(a);
      const auto stage = static_cast<std::size_t>(first_stage_of(column) + substep - 1);
      const Column& changed = columns_[column];
      for (std::size_t k = 0; k < count; ++k) t_[a * count + k] = time(lanes[k], stage);
      for (std::size_t i = 0; i < size; ++i) {
        double* const to = at_.data() + i * all + a * count;
        for (std::size_t k = 0; k < count; ++k) to[k] = x_[i * count + k] + changed.here[i * count + k];
      }
    }
    rhs.many(all, at_.data(), t_.data(), speed_.data());
    for (std::size_t a = 0; a < active; ++a) {
      const int column = first + static_cast<int>(a);
      Column& changed = columns_[column];
      ensure_size(two_substeps_, count);
      for (std::size_t k = 0; k < count; ++k) {
        two_substeps_[k] = lanes[k].block->h[lanes[k].number] * (2.0 / substeps_of(column));
      }
      for (std::size_t i = 0; i < size; ++i) {
        const double* const speed = speed_.data() + i * all + a * count;
        for (std::size_t k = 0; k < count; ++k) {
          double& before = changed.before[i * count + k];
          double& here = changed.here[i * count + k];
          const double next = before + two_substeps_[k] * speed[k];
          before = here;
          here = next;
        }
      }
    }
  }

  void finish(const Rhs& rhs, std::span<const Lane> lanes) {
    const std::size_t count = lanes.size();
    ensure_size(at_, size * count);
    for (std::size_t k = 0; k < count; ++k) {
      StepBlock<Rhs::size>& block = *lanes[k].block;
      const std::size_t lane = lanes[k].number;
      double worst = 0, all = 0;
      for (std::size_t i = 0; i < size; ++i) {
        double change = 0, error = 0;
        for (int column = step_columns - 1; column >= 0; --column) {
          change += extrapolation_weights.change[column] * columns_[column].here[i * count + k];
          error += extrapolation_weights.error[column] * columns_[column].here[i * count + k];
        }
        const double x = x_[i * count + k], slope = slope_[i * count + k];
        const double end = x + change;
        const double h = std::abs(block.h[lane]);
        const double allowed =
            block.tolerance * (block.scale[i][lane] + std::abs(x) + std::abs(h * slope)) + h * block.noise[i][lane];
        const double share = std::abs(error) / allowed;
        worst = share > worst ? share : worst;
        all += share;
        block.end[i][lane] = at_[i * count + k] = end;
        block.slope[i][lane] = slope;
      }
      block.error[lane] = worst + 0.0 * all;  // NaN if any of them is NaN or infinite
    }
    if constexpr (Rhs::forcings == 0) {
      ensure_size(t_, count);
      std::fill_n(t_.begin(), count, 0.0);
      ensure_size(speed_, size * count);
      rhs.many(count, at_.data(), t_.data(), speed_.data());
      for (std::size_t k = 0; k < count; ++k) {
        for (std::size_t i = 0; i < size; ++i) lanes[k].block->end_slope[i][lanes[k].number] = speed_[i * count + k];
      }
    }
  }

  std::vector<double> x_, slope_, at_, speed_, t_, two_substeps_;
  Column columns_[step_columns];
};

/// As run_lanes, with up to `max_lanes` trajectories at a time: a control for each block of them, all of the same
/// queue. `make_control` makes one.
template <typename Rhs, typename MakeControl>
std::uint64_t run_wide(const Rhs& rhs, double tolerance, std::size_t max_lanes, const MakeControl& make_control) {
  using Control = decltype(make_control());
  struct Worker {
    StepBlock<Rhs::size> block{};
    Control control;
    std::size_t live = 0;
    explicit Worker(const MakeControl& make) : control(make()) {}
  };
  std::vector<std::unique_ptr<Worker>> workers;
  bool more = true;
  while (more && workers.size() * block_lanes < max_lanes) {
    auto worker = std::make_unique<Worker>(make_control);
    worker->block.tolerance = tolerance;
    while (worker->live < block_lanes && (more = worker->control.begin(worker->block, worker->live))) ++worker->live;
    if (worker->live > 0) workers.push_back(std::move(worker));
  }
  WideSteps<Rhs> steps;
  std::vector<typename WideSteps<Rhs>::Lane> lanes;
  std::uint64_t computed = 0;
  while (!workers.empty()) {
    throw_if_cancelled();
    lanes.clear();
    for (const auto& worker : workers) {
      for (std::size_t lane = 0; lane < worker->live; ++lane) lanes.push_back({&worker->block, lane});
    }
    steps.compute(rhs, lanes);
    computed += lanes.size();
    for (const auto& worker : workers) judge_lanes(worker->block, worker->control, worker->live);
    std::erase_if(workers, [](const auto& worker) { return worker->live == 0; });
  }
  return computed;
}

/// The trajectories of a queue, by controls that `make_control` makes: by wide steps where the right-hand side asks for
/// them (wide_lanes), by blocks else. Returns the number of steps.
template <typename Rhs, typename MakeControl>
std::uint64_t run_queue(const Rhs& rhs, double tolerance, const MakeControl& make_control) {
  if constexpr (requires { rhs.wide_lanes(); }) {
    if (const std::size_t lanes = rhs.wide_lanes(); lanes > 0) return run_wide(rhs, tolerance, lanes, make_control);
  }
  StepBlock<Rhs::size> block{};
  block.tolerance = tolerance;
  auto control = make_control();
  return run_lanes(rhs, block, step_function<Rhs>(), control);
}

/// PlanarMap::batch of a map whose right-hand side this is: some trajectories in wait for each one that ends.
template <typename Rhs>
std::size_t wide_batch(const Rhs& rhs) {
  if constexpr (requires { rhs.wide_lanes(); }) return 4 * rhs.wide_lanes();
  return 0;
}

/// The step of a block's first lane.
template <typename Rhs>
void single_step(const Rhs& rhs, StepBlock<Rhs::size>& block) {
  if constexpr (requires { rhs.wide_lanes(); }) {
    if (rhs.wide_lanes() > 0) {
      const typename WideSteps<Rhs>::Lane lane{&block, 0};
      WideSteps<Rhs>().compute(rhs, {&lane, 1});
      return;
    }
  }
  steps_one_by_one(rhs, block, 1);
}

}  // namespace lober::detail
