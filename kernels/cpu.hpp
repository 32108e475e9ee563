// The choice of the compiled copy of a vector kernel.
//
// The copies give the same bits, so the choice changes speed only. It is the best that the processor has; the
// environment variable LOBER_ISA (baseline, avx2 or avx512) or limit_instruction_set lowers it, so that tests can
// compare the copies on one machine.
#pragma once

#include <atomic>
#include <span>
#include <string_view>

namespace lober::detail {

/// Each holds the ones before it.
enum class InstructionSet : signed char {
  baseline,  ///< what every x86-64 has (or every machine of another kind)
  avx2,      ///< AVX2 and FMA
  avx512,    ///< and AVX-512 with 256-bit vectors too, whose compares into mask registers save instructions
};

inline constexpr signed char not_chosen = -1;
extern std::atomic<signed char> chosen_instruction_set;
signed char choose_instruction_set() noexcept;

/// The instruction set of the kernels. The first call reads LOBER_ISA; a name that is unknown counts as none. O(1).
[[nodiscard]] inline InstructionSet instruction_set() noexcept {
  const signed char chosen = chosen_instruction_set.load(std::memory_order_relaxed);
  return static_cast<InstructionSet>(chosen != not_chosen ? chosen : choose_instruction_set());
}

/// Runs the kernels with no more than `most` from now on, and never with more than the processor has, whatever
/// LOBER_ISA says. For tests.
void limit_instruction_set(InstructionSet most) noexcept;

/// The best that this processor has.
[[nodiscard]] InstructionSet processor_instruction_set() noexcept;

/// "baseline", "avx2", "avx512": the names that LOBER_ISA takes, in the order of InstructionSet.
[[nodiscard]] std::span<const std::string_view> instruction_set_names() noexcept;

/// Whether the copies for AVX2 and FMA may run.
[[nodiscard]] inline bool has_avx2() noexcept {
  return instruction_set() >= InstructionSet::avx2;
}
/// Whether the copies for AVX-512 may run.
[[nodiscard]] inline bool has_avx512() noexcept {
  return instruction_set() >= InstructionSet::avx512;
}

}  // namespace lober::detail
