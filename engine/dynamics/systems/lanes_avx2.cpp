#define LOBER_LANES_ISA InstructionSet::avx2
#include "engine/dynamics/systems/lanes.inl"
