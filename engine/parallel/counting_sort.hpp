// Sorting by a whole number, in linear time.
#pragma once

#include <cstdint>

#include "engine/memory.hpp"

namespace lober {

struct KeyedNumber {
  std::uint32_t key;
  std::uint32_t number;
};

/// Sorts by key, stably; no key exceeds `largest`. Parallel, deterministic; about two passes of counting sort, one
/// pass when the keys nearly ascend already.
void sort_by_key(Buffer<KeyedNumber>& items, std::uint32_t largest);

}  // namespace lober
