// The steps of all methods in vectors, compiled once for each instruction set (kernels/inline.hpp).
#include "bench/integrators/lane_block.hpp"
#include "bench/integrators/methods.hpp"
#include "engine/dynamics/systems/fields/capsize.hpp"
#include "engine/dynamics/systems/fields/duffing.hpp"
#include "engine/dynamics/systems/fields/three_body.hpp"
#include "engine/dynamics/systems/fields/vortex_pair.hpp"

namespace lober::bench {

template <InstructionSet isa, typename Method, typename Field>
void lane_steps(const Field& field, LaneBlock<Field::dimension>& block) {
  using V = Wide<isa == InstructionSet::avx512 ? 8 : 4, isa>;
  for (std::size_t lane = 0; lane < lanes; lane += V::elements) Method::template step<V>(field, block, lane);
}

#define LOBER_STEPS(Method, Field) \
  template void lane_steps<LOBER_LANES_ISA, Method, Field>(const Field& field, LaneBlock<Field::dimension>& block);
#define LOBER_STEPS_OF(Method)    \
  LOBER_STEPS(Method, VortexPair) \
  LOBER_STEPS(Method, Duffing)    \
  LOBER_STEPS(Method, Capsize)    \
  LOBER_STEPS(Method, ThreeBody)

LOBER_STEPS_OF(RungeKutta<Fehlberg>)
LOBER_STEPS_OF(RungeKutta<DormandPrince>)
LOBER_STEPS_OF(ExtrapolatedMidpoint<5>)
LOBER_STEPS_OF(ExtrapolatedMidpoint<6>)
LOBER_STEPS_OF(ExtrapolatedMidpoint<7>)
LOBER_STEPS_OF(Taylor<12>)
LOBER_STEPS_OF(Taylor<16>)
LOBER_STEPS_OF(Taylor<20>)
LOBER_STEPS_OF(Taylor<24>)

#undef LOBER_STEPS_OF
#undef LOBER_STEPS

}  // namespace lober::bench
