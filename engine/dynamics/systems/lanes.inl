// The steps of the built-in systems in vectors, compiled once for each instruction set (kernels/inline.hpp).
#include "engine/dynamics/integration/lane_steps.hpp"
#include "engine/dynamics/maps/right_hand_sides.hpp"
#include "engine/dynamics/systems/fields/abc.hpp"
#include "engine/dynamics/systems/fields/capsize.hpp"
#include "engine/dynamics/systems/fields/double_gyre.hpp"
#include "engine/dynamics/systems/fields/duffing.hpp"
#include "engine/dynamics/systems/fields/pendulum.hpp"
#include "engine/dynamics/systems/fields/three_body.hpp"
#include "engine/dynamics/systems/fields/vortex_pair.hpp"

namespace lober::detail {

template <InstructionSet isa, typename Rhs>
void steps_in_vectors(const Rhs& rhs, StepBlock<Rhs::size>& block, std::size_t count) {
  using V = Wide<isa == InstructionSet::avx512 ? 8 : 4, isa>;
  for (std::size_t lane = 0; lane < count; lane += V::elements) {
    if (count - lane == 1) {
      extrapolation_step<double>(rhs, block, lane);
    } else {
      extrapolation_step<V>(rhs, block, lane);
    }
  }
}

#define LOBER_STEPS_OF(...)                                                                                    \
  template void steps_in_vectors<LOBER_LANES_ISA>(const __VA_ARGS__& rhs, StepBlock<__VA_ARGS__::size>& block, \
                                                  std::size_t count);
#define LOBER_STEPS(Field)         \
  LOBER_STEPS_OF(AlongFlow<Field>) \
  LOBER_STEPS_OF(WithTangents<Field, 2>)

LOBER_STEPS(Abc)
LOBER_STEPS(VortexPair)
LOBER_STEPS(FirstOrderVortexPair)
LOBER_STEPS(Duffing)
LOBER_STEPS(Pendulum)
LOBER_STEPS(DoubleGyre)
LOBER_STEPS(Capsize)
LOBER_STEPS(ThreeBody)

#undef LOBER_STEPS
#undef LOBER_STEPS_OF

}  // namespace lober::detail
