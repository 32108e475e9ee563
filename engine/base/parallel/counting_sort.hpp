// Sorting numbers by a whole number, in linear time.
#pragma once

#include <atomic>
#include <cstdint>

#include "engine/base/parallel/parallel.hpp"
#include "lober/base/buffer.hpp"

namespace lober::detail {

struct KeyedNumber {
  std::uint32_t key;
  std::uint32_t number;
};

constexpr std::size_t sort_grain = std::size_t{1} << 15;
/// Sorts `count` items by insertion as long as they have to move by a few places only. Gives up otherwise, and then
/// equal items are in their order still. Returns whether they are sorted.
bool insertion_pass(KeyedNumber* items, std::size_t count);
/// Sorts items whose blocks of sort_grain are sorted already, or none need be.
void radix_sort(Buffer<KeyedNumber>& items, std::uint32_t largest, bool blocks_are_sorted);

/// The numbers 0 .. count - 1 with their keys, sorted by key, stably; no key_of(number) exceeds `largest`. Parallel,
/// deterministic; about two passes of counting sort, one pass when the keys nearly ascend already.
template <typename KeyOf>
[[nodiscard]] Buffer<KeyedNumber> sorted_by_key(std::size_t count, std::uint32_t largest, const KeyOf& key_of) {
  Buffer<KeyedNumber> items(count);
  std::atomic<bool> nearly{true};
  for_each_block(count, sort_grain, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) items[k] = {key_of(k), static_cast<std::uint32_t>(k)};
    if (nearly.load(std::memory_order_relaxed) && !insertion_pass(&items[first], last - first)) nearly = false;
  });
  radix_sort(items, largest, nearly);
  return items;
}

}  // namespace lober::detail
