// The part of a field that depends on time alone, tabulated over its period.
#pragma once

#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "engine/dynamics/integration/extrapolation.hpp"

namespace lober::detail {

/// The forcing at all stages of a step, from any time on.
template <typename Field>
void tabulate_step(const Field& field, double from, double h, double* record) {
  for (std::size_t stage = 0; stage < step_stages; ++stage) {
    field.forcing(from + stage_offset(static_cast<int>(stage)) * h, record + stage * Field::forcings);
  }
}

/// The forcing of a time-periodic field: steps of period / 2^level that begin at whole multiples of themselves, forward
/// or backward from `start`, see the same few times over and over. The table of a level is made when it is first asked
/// for; from `tabulated_levels` on a step computes its own. Safe to use from several threads.
template <typename Field>
class ForcingTable {
 public:
  static constexpr int tabulated_levels = 10;
  static constexpr std::size_t record_size = step_stages * Field::forcings;

  /// `start`: a time.
  ForcingTable(Field field, double start) : field_(std::move(field)), start_(start), period_(field_.period()) {}

  [[nodiscard]] const Field& field() const { return field_; }
  [[nodiscard]] double period() const { return period_; }

  /// Step number `position` of `level` in the direction of time `forward`, for StepBlock::forcing; `own` holds it where
  /// it is not tabulated.
  [[nodiscard]] const double* record(int forward, int level, std::int64_t position, double* own) const {
    if (level < tabulated_levels) {
      return table(forward, level) + static_cast<std::size_t>(position) * record_size;
    }
    fill(forward, level, position, own);
    return own;
  }

 private:
  struct Level {
    std::atomic<const double*> ready{nullptr};
    std::once_flag once;
    std::vector<double> records;
  };

  const double* table(int forward, int level) const {
    Level& found = levels_[forward > 0 ? 1 : 0][static_cast<std::size_t>(level)];
    if (const double* const ready = found.ready.load(std::memory_order_acquire)) return ready;
    std::call_once(found.once, [&] {
      const std::size_t steps = std::size_t{1} << static_cast<unsigned>(level);
      std::vector<double> records(steps * record_size);
      for (std::size_t k = 0; k < steps; ++k) {
        fill(forward, level, static_cast<std::int64_t>(k), records.data() + k * record_size);
      }
      found.records = std::move(records);
      found.ready.store(found.records.data(), std::memory_order_release);
    });
    return found.records.data();
  }

  void fill(int forward, int level, std::int64_t position, double* record) const {
    const double scale = std::ldexp(forward * period_, -level);
    for (std::size_t stage = 0; stage < step_stages; ++stage) {
      const double steps = static_cast<double>(position) + stage_offset(static_cast<int>(stage));
      field_.forcing(start_ + steps * scale, record + stage * Field::forcings);
    }
  }

  Field field_;
  double start_;
  double period_;
  mutable std::array<std::array<Level, tabulated_levels>, 2> levels_;
};

}  // namespace lober::detail
