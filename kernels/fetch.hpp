// Asking for memory before its turn.
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernels/inline.hpp"

namespace lober::detail {

/// How far ahead a pass over long curves asks: processors fetch ahead by themselves, but not enough.
inline constexpr std::ptrdiff_t bytes_ahead = 8192, bytes_a_line = 64;

/// Asks for the cache line `bytes` behind `from`, before it if negative, whatever is there.
LOBER_INLINE void fetch(const void* from, std::ptrdiff_t bytes) {
  __builtin_prefetch(reinterpret_cast<const void*>(reinterpret_cast<std::intptr_t>(from) + bytes));
}

}  // namespace lober::detail
