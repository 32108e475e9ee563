#define LOBER_LANES_ISA InstructionSet::avx512
#include "bench/integrators/lanes.inl"
