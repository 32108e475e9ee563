// Steps of several trajectories at once: their input and output.
#pragma once

#include <cstddef>

namespace lober::detail {

/// The modified midpoint rule is taken with 2, 4, ..., 2 step_columns substeps (extrapolation.hpp).
inline constexpr int step_columns = 6;
/// Evaluations of the right-hand side for a step.
inline constexpr std::size_t step_stages = 1 + step_columns * step_columns;
/// Steps in a block: as many as the widest vectors hold.
inline constexpr std::size_t block_lanes = 8;

/// Column `lane` of each array is one step; nothing in it depends on the others.
template <int size>
struct alignas(64) StepBlock {
  using Row = double[block_lanes];

  // Given.
  Row x[size];                         ///< the state where the step begins
  Row h;                               ///< its length, of either sign
  const double* forcing[block_lanes];  ///< the numbers of Field::forcing at stage_offset(0), stage_offset(1), ...
  double tolerance = 0;
  // For right-hand sides of one's own units only (own_units):
  Row scale[size];                ///< the largest size of each component on its trajectory so far
  bool widens[block_lanes] = {};  ///< whether that grows with it
  Row noise[size];                ///< rounding of its velocity, as far as it is known (component_scales.hpp)

  // Computed.
  Row end[size];    ///< the state where it ends
  Row error;        ///< estimated over allowed error: above 1, or NaN, the step is too long
  Row slope[size];  ///< dx/dt where it begins
  // For autonomous fields only:
  Row end_slope[size];                  ///< dx/dt where it ends
  Row way[2 * step_columns - 1][size];  ///< the change of the state at equal distances over the step, to O(h^2 / 100)

  /// All but `forcing`, of which the caller knows where it lies.
  void copy_lane(std::size_t from, std::size_t to) {
    h[to] = h[from];
    widens[to] = widens[from];
    error[to] = error[from];
    for (int i = 0; i < size; ++i) {
      x[i][to] = x[i][from];
      end[i][to] = end[i][from];
      slope[i][to] = slope[i][from];
      scale[i][to] = scale[i][from];
      noise[i][to] = noise[i][from];
      end_slope[i][to] = end_slope[i][from];
      for (auto& part : way) part[i][to] = part[i][from];
    }
  }
};

}  // namespace lober::detail
