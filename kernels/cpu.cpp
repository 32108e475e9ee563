#include "kernels/cpu.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>

namespace lober::detail {
namespace {

constexpr std::string_view names[] = {"baseline", "avx2", "avx512"};

}  // namespace

std::atomic<signed char> chosen_instruction_set{not_chosen};

InstructionSet processor_instruction_set() noexcept {
#if defined(__x86_64__)
  __builtin_cpu_init();  // the first call may come before the constructors of the program have run
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) return InstructionSet::baseline;
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                 __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("bmi2")
             ? InstructionSet::avx512
             : InstructionSet::avx2;
#else
  return InstructionSet::baseline;
#endif
}

void limit_instruction_set(InstructionSet most) noexcept {
  const InstructionSet chosen = std::min(most, processor_instruction_set());
  chosen_instruction_set.store(static_cast<signed char>(chosen), std::memory_order_relaxed);
}

std::span<const std::string_view> instruction_set_names() noexcept {
  return names;
}

// Several threads may choose at once; all choose the same.
signed char choose_instruction_set() noexcept {
  const char* const asked = std::getenv("LOBER_ISA");
  const auto* const found = std::find(std::begin(names), std::end(names), asked != nullptr ? asked : "");
  limit_instruction_set(found != std::end(names) ? static_cast<InstructionSet>(found - names) : InstructionSet::avx512);
  return chosen_instruction_set.load(std::memory_order_relaxed);
}

}  // namespace lober::detail
