// Which compiled copy of a vector kernel this machine may run.
#pragma once

namespace lober {

/// True when the processor has AVX2 and FMA. The answer never changes results, only speed. O(1).
inline bool has_avx2() {
#if defined(__x86_64__)
  static const bool answer = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  return answer;
#else
  return false;
#endif
}

/// True when the processor has AVX-512 with 256-bit vectors too, whose compares into mask registers save instructions.
inline bool has_avx512() {
#if defined(__x86_64__)
  static const bool answer = has_avx2() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                             __builtin_cpu_supports("avx512dq");
  return answer;
#else
  return false;
#endif
}

}  // namespace lober
