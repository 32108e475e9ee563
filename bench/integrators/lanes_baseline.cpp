#define LOBER_LANES_ISA InstructionSet::baseline
#include "bench/integrators/lanes.inl"
