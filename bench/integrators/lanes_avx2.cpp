#define LOBER_LANES_ISA InstructionSet::avx2
#include "bench/integrators/lanes.inl"
