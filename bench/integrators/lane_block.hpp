// Steps of eight trajectories at once, whatever the method, and which compiled copy computes them.
#pragma once

#include <cstddef>

#include "kernels/cpu.hpp"
#include "kernels/wide.hpp"

namespace lober::bench {
using namespace lober::detail;

inline constexpr std::size_t lanes = 8;

/// How long a step may be after one whose error was `error` of what is allowed, as a factor. Errors count as the next
/// power of two, so that no logarithm is taken in the loop.
struct StepFactors {
  static constexpr int lowest = -160, highest = 60;
  double of[highest - lowest + 1];
};

/// Column `lane` of each array is one step; nothing in it depends on the others.
template <int size>
struct alignas(64) LaneBlock {
  using Row = double[lanes];

  // Given.
  Row x[size];                   ///< the state where the step begins
  Row h;                         ///< its length
  Row limit;                     ///< how much longer than h a method with a choice (Method::chooses) may make it
  const double* forcing[lanes];  ///< what the method tabulated for the step
  double tolerance;              ///< of an error: tolerance * (1 + |x| + |h dx/dt|)
  const StepFactors* factors;    ///< for methods with a choice

  // Computed.
  Row end[size];
  Row error;  ///< estimated, over what is allowed: above 1, or NaN, the step is too long
  Row taken;  ///< of methods with a choice: the length of the step over h; the error is then small enough
};

/// The forcing tabulated for evaluation number `stage` of the step in each lane.
template <typename Field, typename V>
LOBER_INLINE void gather_forcing(const double* const* forcing, int stage, V* force) {
  constexpr int count = static_cast<int>(Field::forcings);
  for (int f = 0; f < count; ++f) force[f] = gather_number<V>(forcing, static_cast<std::size_t>(stage * count + f));
}

/// Computes all lanes.
template <typename Field>
using StepFunction = void (*)(const Field& field, LaneBlock<Field::dimension>& block);

/// Instantiated in lanes_*.cpp, for all methods and fields that are compared.
template <InstructionSet isa, typename Method, typename Field>
void lane_steps(const Field& field, LaneBlock<Field::dimension>& block);

template <typename Method, typename Field>
StepFunction<Field> step_function() {
  switch (instruction_set()) {
    case InstructionSet::avx512:
      return lane_steps<InstructionSet::avx512, Method, Field>;
    case InstructionSet::avx2:
      return lane_steps<InstructionSet::avx2, Method, Field>;
    case InstructionSet::baseline:
      break;
  }
  return lane_steps<InstructionSet::baseline, Method, Field>;
}

}  // namespace lober::bench
