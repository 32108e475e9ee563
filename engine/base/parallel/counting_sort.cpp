#include "engine/base/parallel/counting_sort.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace lober::detail {
namespace {

constexpr std::uint32_t digit_bits = 11;
constexpr std::size_t digits = std::size_t{1} << digit_bits;

// One stable pass of counting sort by the digit at `shift`. The grain fixes the pieces, so the result does not depend
// on threads (a stable sort has one result anyway).
void sort_by_digit(const Buffer<KeyedNumber>& from, Buffer<KeyedNumber>& to, std::uint32_t shift) {
  const std::size_t pieces = (from.size() + sort_grain - 1) / sort_grain;
  std::vector<std::array<std::uint32_t, digits>> begin(pieces);
  const auto digit = [shift](const KeyedNumber& item) { return (item.key >> shift) & (digits - 1); };
  for_each_block(from.size(), sort_grain, [&](std::size_t first, std::size_t last) {
    auto& count = begin[first / sort_grain];
    count.fill(0);
    for (std::size_t k = first; k < last; ++k) ++count[digit(from[k])];
  });
  std::uint32_t total = 0;
  for (std::size_t value = 0; value < digits; ++value) {
    for (auto& piece : begin) {
      const std::uint32_t count = piece[value];
      piece[value] = total;
      total += count;
    }
  }
  for_each_block(from.size(), sort_grain, [&](std::size_t first, std::size_t last) {
    auto& next = begin[first / sort_grain];
    for (std::size_t k = first; k < last; ++k) to[next[digit(from[k])]++] = from[k];
  });
}

// Moves items[k] down to its place among the items before it, which are sorted; not further than a few places.
// Returns whether that was enough.
bool settle_one(KeyedNumber* items, std::size_t k) {
  constexpr std::size_t furthest = 8;
  const KeyedNumber item = items[k];
  const std::size_t lowest = k < furthest ? 0 : k - furthest;
  std::size_t m = k;
  for (; m > lowest && items[m - 1].key > item.key; --m) items[m] = items[m - 1];
  items[m] = item;
  return m == 0 || items[m - 1].key <= item.key;
}

// Joins sorted blocks as long as items have to move by a few places only, as those of curves that run side by side do.
bool join_blocks(Buffer<KeyedNumber>& items) {
  for (std::size_t border = sort_grain; border < items.size(); border += sort_grain) {
    for (std::size_t k = border; k < items.size() && items[k].key < items[k - 1].key; ++k) {
      if (!settle_one(items.data(), k)) return false;
    }
  }
  return true;
}

}  // namespace

bool insertion_pass(KeyedNumber* items, std::size_t count) {
  for (std::size_t k = 1; k < count; ++k) {
    if (!settle_one(items, k)) return false;
  }
  return true;
}

void radix_sort(Buffer<KeyedNumber>& items, std::uint32_t largest, bool blocks_are_sorted) {
  if (blocks_are_sorted && join_blocks(items)) return;
  const auto less = [](const KeyedNumber& x, const KeyedNumber& y) { return x.key < y.key; };
  if (items.size() < digits) {
    std::stable_sort(items.begin(), items.end(), less);
    return;
  }
  Buffer<KeyedNumber> other(items.size());
  for (std::uint32_t shift = 0; shift < 32 && largest >> shift != 0; shift += digit_bits) {
    sort_by_digit(items, other, shift);
    items.swap(other);
  }
}

}  // namespace lober::detail
