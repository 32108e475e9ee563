#define LOBER_KERNELS avx2_kernels
#include "kernels/all.inl"
