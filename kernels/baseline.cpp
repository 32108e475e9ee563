#define LOBER_KERNELS baseline_kernels
#include "kernels/all.inl"
