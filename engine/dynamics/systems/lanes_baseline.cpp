#define LOBER_LANES_ISA InstructionSet::baseline
#include "engine/dynamics/systems/lanes.inl"
