// The compiled copy of the step that a processor takes.
#pragma once

#include <cstddef>
#include <cstdint>

#include "engine/dynamics/integration/extrapolation.hpp"
#include "engine/dynamics/integration/step_block.hpp"
#include "kernels/cpu.hpp"

namespace lober::detail {

/// Computes the steps of lanes 0 .. count - 1 of a block.
template <typename Rhs>
using StepFunction = void (*)(const Rhs& rhs, StepBlock<Rhs::size>& block, std::size_t count);

/// Tenths of work (PlanarMap::work) for an evaluation of a field: those of several trajectories at a time count one.
template <typename Field>
std::uint64_t tenths_of_work(const Field& field) {
  if constexpr (requires { field.tenths(); }) {
    return field.tenths();
  } else {
    return Field::in_lanes ? 1 : 10;
  }
}

/// One lane after the other: for right-hand sides that take plain doubles only, or of which one trajectory is wanted.
template <typename Rhs>
void steps_one_by_one(const Rhs& rhs, StepBlock<Rhs::size>& block, std::size_t count) {
  for (std::size_t lane = 0; lane < count; ++lane) extrapolation_step<double>(rhs, block, lane);
}

/// Vectors of the instruction set, and a plain double for a last one alone. Instantiated in
/// engine/dynamics/systems/lanes_*.cpp, for all right-hand sides of the built-in systems.
template <InstructionSet isa, typename Rhs>
void steps_in_vectors(const Rhs& rhs, StepBlock<Rhs::size>& block, std::size_t count);

/// Rhs::in_lanes: whether steps_in_vectors is instantiated for it. A right-hand side may bring its own function
/// instead.
template <typename Rhs>
StepFunction<Rhs> step_function() {
  if constexpr (requires { Rhs::own_steps(); }) {
    return Rhs::own_steps();
  } else if constexpr (Rhs::in_lanes) {
    switch (instruction_set()) {
      case InstructionSet::avx512:
        return steps_in_vectors<InstructionSet::avx512, Rhs>;
      case InstructionSet::avx2:
        return steps_in_vectors<InstructionSet::avx2, Rhs>;
      case InstructionSet::baseline:
        break;
    }
    return steps_in_vectors<InstructionSet::baseline, Rhs>;
  } else {
    return steps_one_by_one<Rhs>;
  }
}

}  // namespace lober::detail
