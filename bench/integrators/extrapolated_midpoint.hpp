// Gragg's method with extrapolation from any number of columns: six are the step of lober.
#pragma once

#include <cstddef>
#include <string>

#include "bench/integrators/lane_block.hpp"
#include "engine/dynamics/integration/extrapolation.hpp"
#include "engine/dynamics/maps/right_hand_sides.hpp"

namespace lober::bench {

template <int columns>
struct ExtrapolatedMidpoint {
  static constexpr bool chooses = false;
  static constexpr int error_power = 2 * columns - 1;
  static constexpr int stages = first_stage_of(columns);
  static std::string name() { return "Gragg-Bulirsch-Stoer " + std::to_string(2 * columns); }

  template <typename Field>
  static constexpr std::size_t record_size = stages* Field::forcings;
  template <typename Field>
  static void tabulate(const Field& field, double from, double h, double* record) {
    for (int s = 0; s < stages; ++s) {
      field.forcing(from + stage_offset(s) * h, record + static_cast<std::size_t>(s) * Field::forcings);
    }
  }

  template <typename V, typename Field>
  LOBER_INLINE static void step(const Field& field, LaneBlock<Field::dimension>& block, std::size_t lane) {
    constexpr int size = Field::dimension;
    using Column = MidpointColumn<V, size>;
    const AlongFlow<Field> rhs{field};
    const double* const* const forcing = block.forcing + lane;
    const V h = load_number<V>(block.h + lane);
    V x[size], slope[size], force[Field::forcings + 1];
    for (int i = 0; i < size; ++i) x[i] = load_number<V>(block.x[i] + lane);
    gather_forcing<Field>(forcing, 0, force);
    rhs(x, slope, force);

    V change[size], error[size];
    for (int i = 0; i < size; ++i) change[i] = error[i] = V(0.0);
    const auto add = [&](const Column& column, int k) __attribute__((always_inline)) {
      for (int i = 0; i < size; ++i) {
        change[i] += weights.change[k] * column.here[i];
        error[i] += weights.error[k] * column.here[i];
      }
    };
    // Two columns side by side, as in engine/dynamics/integration/extrapolation.hpp; of an odd number, one alone.
    for (int k = columns - 1; k > 0; k -= 2) {
      Column fine(k, h, slope), coarse(k - 1, h, slope);
      for (int substep = 1; substep < substeps_of(k); ++substep) {
        fine.advance(rhs, x, forcing);
        if (substep < substeps_of(k - 1)) coarse.advance(rhs, x, forcing);
      }
      add(fine, k);
      add(coarse, k - 1);
    }
    if constexpr (columns % 2 == 1) {
      Column alone(0, h, slope);
      alone.advance(rhs, x, forcing);
      add(alone, 0);
    }

    V worst(0.0), all(0.0);
    for (int i = 0; i < size; ++i) {
      store_number(block.end[i] + lane, x[i] + change[i]);
      const V allowed = block.tolerance * (1.0 + magnitude(x[i]) + magnitude(h * slope[i]));
      const V share = magnitude(error[i]) / allowed;
      worst = greater_number(worst, share);
      all += share;
    }
    store_number(block.error + lane, worst + 0.0 * all);
  }

 private:
  struct Weights {
    double change[columns], error[columns];
  };
  static constexpr double weight(int column, int first) {
    double result = column < first ? 0 : 1;
    for (int other = first; other < columns; ++other) {
      if (other == column) continue;
      const double here = substeps_of(column) * substeps_of(column), there = substeps_of(other) * substeps_of(other);
      result *= here / (here - there);
    }
    return result;
  }
  static constexpr Weights weights = [] {
    Weights result{};
    for (int k = 0; k < columns; ++k) {
      result.change[k] = weight(k, 0);
      result.error[k] = weight(k, 0) - weight(k, 1);
    }
    return result;
  }();
};

}  // namespace lober::bench
