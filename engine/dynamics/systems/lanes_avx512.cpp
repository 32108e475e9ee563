#define LOBER_LANES_ISA InstructionSet::avx512
#include "engine/dynamics/systems/lanes.inl"
