#define LOBER_KERNELS avx512_kernels
#include "kernels/all.inl"
