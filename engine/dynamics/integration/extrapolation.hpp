// Gragg's method with extrapolation: a step of dx/dt = rhs(x, t) for any kind of number.
//
// The modified midpoint rule is taken with 2, 4, ..., 12 substeps, and the six results are extrapolated to substeps of
// length zero: order 12, with the extrapolation without the coarsest one (order 10) for the error (Gragg 1965; Hairer,
// Norsett & Wanner, Solving Ordinary Differential Equations I, II.9). The quantity carried along and extrapolated is
// the change over the step, not the state, so that rounding falls with the step. Beside a Runge-Kutta pair of order 8 a
// step takes three times as many evaluations of the field and is three times as long; but an evaluation comes with one
// product and one sum a coordinate instead of up to a dozen of each, and columns do not wait for one another
// (bench/RESULTS.md, "Integrators").
#pragma once

#include <cstddef>

#include "engine/dynamics/integration/step_block.hpp"
#include "kernels/wide.hpp"

namespace lober::detail {

LOBER_INLINE constexpr int substeps_of(int column) {
  return 2 * (column + 1);
}

/// Evaluations of the right-hand side are numbered: the beginning of the step, then those inside of column 0, column 1
/// and so on. This is the first one of a column.
LOBER_INLINE constexpr int first_stage_of(int column) {
  return 1 + column * column;
}
static_assert(first_stage_of(step_columns) == step_stages);

/// The fraction of the step at which evaluation number `stage` takes place.
constexpr double stage_offset(int stage) {
  if (stage == 0) return 0;
  int column = 0;
  while (first_stage_of(column + 1) <= stage) ++column;
  return static_cast<double>(stage - first_stage_of(column) + 1) / substeps_of(column);
}

/// The weight of a column in the extrapolation from the columns `first`, `first` + 1 ...: the value at 0 of the
/// polynomial in the square of the substep that is 1 at this column and 0 at the others.
constexpr double column_weight(int column, int first) {
  double weight = column < first ? 0 : 1;
  for (int other = first; other < step_columns; ++other) {
    if (other == column) continue;
    const double here = substeps_of(column) * substeps_of(column), there = substeps_of(other) * substeps_of(other);
    weight *= here / (here - there);
  }
  return weight;
}

struct ExtrapolationWeights {
  double change[step_columns];
  double error[step_columns];  ///< weights of the difference between both extrapolations
};
inline constexpr ExtrapolationWeights extrapolation_weights = [] {
  ExtrapolationWeights result{};
  for (int k = 0; k < step_columns; ++k) {
    result.change[k] = column_weight(k, 0);
    result.error[k] = column_weight(k, 0) - column_weight(k, 1);
  }
  return result;
}();

/// A column on its way over the step.
template <typename V, int size>
struct MidpointColumn {
  V before[size], here[size];  ///< the changes of the state up to the last two substeps
  V two_substeps;
  std::size_t stage;

  LOBER_INLINE MidpointColumn(int column, V h, const V* slope)
      : two_substeps(h * (2.0 / substeps_of(column))), stage(static_cast<std::size_t>(first_stage_of(column))) {
    const V substep = h * (1.0 / substeps_of(column));
    for (int i = 0; i < size; ++i) {
      before[i] = V(0.0);
      here[i] = substep * slope[i];
    }
  }

  template <typename Rhs>
  LOBER_INLINE void advance(const Rhs& rhs, const V* x, const double* const* forcing) {
    V at[size], slope[size], force[Rhs::forcings + 1];
    for (int i = 0; i < size; ++i) at[i] = x[i] + here[i];
    for (std::size_t f = 0; f < Rhs::forcings; ++f) force[f] = gather_number<V>(forcing, stage * Rhs::forcings + f);
    rhs(at, slope, force);
    for (int i = 0; i < size; ++i) {
      const V next = before[i] + two_substeps * slope[i];
      before[i] = here[i];
      here[i] = next;
    }
    ++stage;
  }

  LOBER_INLINE void add_to(V* change, V* error, int column) const {
    for (int i = 0; i < size; ++i) {
      change[i] += extrapolation_weights.change[column] * here[i];
      error[i] += extrapolation_weights.error[column] * here[i];
    }
  }
};

/// The steps of block in the lanes from `lane` on, as many as a V holds. Rhs: size, forcings (numbers that depend on
/// time only, for each stage), own_units (component_scales.hpp) and operator()(const V* x, V* dxdt, const V* forcing).
template <typename V, typename Rhs>
LOBER_INLINE void extrapolation_step(const Rhs& rhs, StepBlock<Rhs::size>& block, std::size_t lane) {
  constexpr int size = Rhs::size;
  const double* const* const forcing = block.forcing + lane;
  const V h = load_number<V>(block.h + lane);
  V x[size], slope[size], force[Rhs::forcings + 1];
  for (int i = 0; i < size; ++i) x[i] = load_number<V>(block.x[i] + lane);
  for (std::size_t f = 0; f < Rhs::forcings; ++f) force[f] = gather_number<V>(forcing, f);
  rhs(x, slope, force);

  V change[size], error[size];
  for (int i = 0; i < size; ++i) change[i] = error[i] = V(0.0);
  // Two columns side by side, so that one computes while the other one waits for its last result.
  static_assert(step_columns % 2 == 0);
  for (int column = step_columns - 1; column > 0; column -= 2) {
    MidpointColumn<V, size> fine(column, h, slope), coarse(column - 1, h, slope);
    for (int k = 1; k < substeps_of(column); ++k) {
      if constexpr (Rhs::forcings == 0) {
        if (column == step_columns - 1) {
          for (int i = 0; i < size; ++i) store_number(block.way[k - 1][i] + lane, fine.here[i]);
        }
      }
      fine.advance(rhs, x, forcing);
      if (k < substeps_of(column - 1)) coarse.advance(rhs, x, forcing);
    }
    fine.add_to(change, error, column);
    coarse.add_to(change, error, column - 1);
  }

  V worst(0.0), all(0.0), end[size];
  for (int i = 0; i < size; ++i) {
    end[i] = x[i] + change[i];
    V allowed(0.0);
    if constexpr (Rhs::own_units) {
      allowed = block.tolerance * (load_number<V>(block.scale[i] + lane) + magnitude(x[i]) + magnitude(h * slope[i])) +
                magnitude(h) * load_number<V>(block.noise[i] + lane);
    } else {
      allowed = block.tolerance * (1.0 + magnitude(x[i]) + magnitude(h * slope[i]));
    }
    const V share = magnitude(error[i]) / allowed;
    worst = greater_number(worst, share);
    all += share;
    store_number(block.end[i] + lane, end[i]);
    store_number(block.slope[i] + lane, slope[i]);
  }
  // NaN if any of them is NaN or infinite.
  store_number(block.error + lane, worst + 0.0 * all);
  if constexpr (Rhs::forcings == 0) {
    rhs(end, slope, force);
    for (int i = 0; i < size; ++i) store_number(block.end_slope[i] + lane, slope[i]);
  }
}

}  // namespace lober::detail
