// Findings of a search in a block of the first curve, sorted by its segments (private to geometry/).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "engine/geometry/index/index.hpp"
#include "lober/base/buffer.hpp"

namespace lober::detail {

/// Sorts by segment(item), a number from first_segment on of one block, and keeps the order of items on one segment. A
/// counting sort where there are many: a block has few segments.
template <typename Item, typename SegmentOf>
void sort_by_segment(Buffer<Item>& items, std::uint32_t first_segment, const SegmentOf& segment) {
  const auto less = [&](const Item& x, const Item& y) { return segment(x) < segment(y); };
  if (std::is_sorted(items.begin(), items.end(), less)) return;
  if (items.size() < block_segments / 16) {
    for (auto next = items.begin() + 1; next != items.end(); ++next) {
      std::rotate(std::upper_bound(items.begin(), next, *next, less), next, next + 1);
    }
    return;
  }
  std::array<std::uint32_t, block_segments + 1> begin{};
  for (const Item& item : items) ++begin[segment(item) - first_segment + 1];
  for (std::uint32_t k = 0; k < block_segments; ++k) begin[k + 1] += begin[k];
  Buffer<Item> sorted(items.size());
  for (const Item& item : items) sorted[begin[segment(item) - first_segment]++] = item;
  items.swap(sorted);
}

}  // namespace lober::detail
