// Functions that several compiled copies of a kernel share.
#pragma once

/// Kernels are compiled once for each instruction set. An inline function that such a copy calls without inlining it
/// (without optimisation: every one, those of the standard library too) would be emitted as a weak symbol in that
/// instruction set, and the linker could choose it for the whole program, which then dies on older processors. So
/// whatever a *.inl file calls is always inlined or in an unnamed namespace; tests/kernels/isa_symbols.sh inspects the
/// objects.
#define LOBER_INLINE [[gnu::always_inline]] inline
