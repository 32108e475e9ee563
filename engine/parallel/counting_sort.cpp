#include "engine/parallel/counting_sort.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "engine/parallel/parallel.hpp"

namespace lober {
namespace {

constexpr std::size_t grain = std::size_t{1} << 15;
constexpr std::uint32_t digit_bits = 11;
constexpr std::size_t digits = std::size_t{1} << digit_bits;

// One stable pass of counting sort by the digit at `shift`. The grain fixes the pieces, so the result does not depend
// on threads (a stable sort has one result anyway).
void sort_by_digit(const Buffer<KeyedNumber>& from, Buffer<KeyedNumber>& to, std::uint32_t shift) {
  const std::size_t pieces = (from.size() + grain - 1) / grain;
  std::vector<std::array<std::uint32_t, digits>> begin(pieces);
  const auto digit = [shift](const KeyedNumber& item) { return (item.key >> shift) & (digits - 1); };
  for_each_block(from.size(), grain, [&](std::size_t first, std::size_t last) {
    auto& count = begin[first / grain];
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
  for_each_block(from.size(), grain, [&](std::size_t first, std::size_t last) {
    auto& next = begin[first / grain];
    for (std::size_t k = first; k < last; ++k) to[next[digit(from[k])]++] = from[k];
  });
}

}  // namespace

void sort_by_key(Buffer<KeyedNumber>& items, std::uint32_t largest) {
  const auto less = [](const KeyedNumber& x, const KeyedNumber& y) { return x.key < y.key; };
  if (std::is_sorted(items.begin(), items.end(), less)) return;
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

}  // namespace lober
