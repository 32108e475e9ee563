// How long the next step is.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "engine/dynamics/integration/component_scales.hpp"
#include "engine/dynamics/integration/step_block.hpp"
#include "kernels/elementary.hpp"
#include "lober/dynamics/flow.hpp"

namespace lober::detail {

/// The error that is estimated is that of order 10: it falls with this power of the step.
inline constexpr int error_power = 2 * step_columns - 1;

/// Whether a step may be doubled after one of this error, with half of the allowed error to spare.
inline bool may_double(double error) {
  constexpr double limit = 1.0 / (std::uint64_t{1} << (error_power + 1));
  return error < limit;
}

/// For errors from 2^lowest to 2^highest: their power -1/11, less a twentieth, between 1/8 and 4.
struct StepFactors {
  static constexpr int lowest = -24, highest = 36;
  double of[highest - lowest + 1]{};
  constexpr StepFactors() {
    constexpr double root_of_half = 0.93893091066170633;  // 2^(-1/11)
    for (int exponent = lowest; exponent <= highest; ++exponent) {
      double factor = 0.95;
      for (int k = 0; k < exponent; ++k) factor *= root_of_half;
      for (int k = exponent; k < 0; ++k) factor /= root_of_half;
      of[exponent - lowest] = std::clamp(factor, 0.125, 4.0);
    }
  }
};
inline constexpr StepFactors step_factors;

/// The factor for a step whose error was `error` times the allowed one, or NaN. The error counts as the next
/// power of two, so that no logarithm is taken.
inline double step_factor(double error) {
  if (!std::isfinite(error)) return 0.125;
  if (error <= 0) return 4;
  const int exponent = std::clamp(std::ilogb(error) + 1, StepFactors::lowest, StepFactors::highest);
  return step_factors.of[exponent - StepFactors::lowest];
}

/// A step on which the guarded coordinates change by about the eleventh root of the tolerance, relative to their size
/// (Hairer, Norsett & Wanner, II.4, in short): from the point alone, so that a point does not depend on its batch.
/// `longest`: where coordinates may be in any unit (own_units).
template <typename Rhs>
double first_step(const Rhs& rhs, const double* x, const double* slope, int guarded, double tolerance, double longest) {
  double unit = 1;
  if constexpr (Rhs::own_units) {
    unit = rhs.field.unit();
    if (!has_large_coordinate(x, guarded, unit)) {
      return first_step_by_sizes(x, slope, guarded, elementary::power(tolerance, 1.0 / error_power), longest);
    }
  }
  double size = 0, speed = 0;
  for (int k = 0; k < guarded; ++k) {
    size = std::max(size, std::abs(x[k]));
    speed = std::max(speed, std::abs(slope[k]));
  }
  return elementary::power(tolerance, 1.0 / error_power) *
         std::clamp((unit + size) / std::max(speed, 1e-3 * unit), 1e-6, 10.0);
}

/// Whether the state at the end of a step is one to go on from. Only the first `guarded` components are compared with
/// options.escape (the others are tangent vectors and the like, which may grow).
template <int size>
bool end_in_bounds(const StepBlock<size>& block, std::size_t lane, int guarded, double escape) {
  for (int i = 0; i < size; ++i) {
    if (!(std::abs(block.end[i][lane]) <= (i < guarded ? escape : 1e300))) return false;
  }
  return true;
}

}  // namespace lober::detail
