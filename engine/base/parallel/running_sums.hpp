// Count, sum up, write: how a pass over a curve finds the index of its output (private to the engine).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "lober/base/buffer.hpp"

namespace lober::detail {

/// Elements that one task handles; fixed, so that results do not depend on threads.
inline constexpr std::size_t pass_grain = std::size_t{1} << 14;

/// begin[k] = count(0) + ... + count(k - 1) for k = 0, ..., size. Calls `count` twice for each k, in parallel.
template <typename Count>
Buffer<std::uint64_t> running_sums(std::size_t size, const Count& count) {
  const std::size_t blocks = (size + pass_grain - 1) / pass_grain;
  std::vector<std::uint64_t> block_begin(blocks + 1, 0);
  for_each_block(size, pass_grain, [&](std::size_t first, std::size_t last) {
    std::uint64_t sum = 0;
    for (std::size_t k = first; k < last; ++k) sum += count(k);
    block_begin[first / pass_grain + 1] = sum;
  });
  for (std::size_t block = 0; block < blocks; ++block) block_begin[block + 1] += block_begin[block];
  Buffer<std::uint64_t> begin(size + 1);
  for_each_block(size, pass_grain, [&](std::size_t first, std::size_t last) {
    std::uint64_t sum = block_begin[first / pass_grain];
    for (std::size_t k = first; k < last; ++k) {
      begin[k] = sum;
      sum += count(k);
    }
  });
  begin[size] = block_begin[blocks];
  return begin;
}

/// The sum alone.
template <typename Count>
std::uint64_t sum_of(std::size_t size, const Count& count) {
  std::vector<std::uint64_t> sums((size + pass_grain - 1) / pass_grain, 0);
  for_each_block(size, pass_grain, [&](std::size_t first, std::size_t last) {
    std::uint64_t sum = 0;
    for (std::size_t k = first; k < last; ++k) sum += count(k);
    sums[first / pass_grain] = sum;
  });
  std::uint64_t total = 0;
  for (const std::uint64_t sum : sums) total += sum;
  return total;
}

/// The numbers k < size for which keep(k) holds, each turned into an element by make(k), in order.
template <typename T, typename Keep, typename Make>
Buffer<T> gathered(std::size_t size, const Keep& keep, const Make& make) {
  std::vector<std::size_t> begin((size + pass_grain - 1) / pass_grain + 1, 0);
  for_each_block(size, pass_grain, [&](std::size_t first, std::size_t last) {
    std::size_t count = 0;
    for (std::size_t k = first; k < last; ++k) count += keep(k) ? 1 : 0;
    begin[first / pass_grain + 1] = count;
  });
  for (std::size_t block = 1; block < begin.size(); ++block) begin[block] += begin[block - 1];
  Buffer<T> result(begin.back());
  for_each_block(size, pass_grain, [&](std::size_t first, std::size_t last) {
    std::size_t next = begin[first / pass_grain];
    for (std::size_t k = first; k < last; ++k) {
      if (keep(k)) result[next++] = make(k);
    }
  });
  return result;
}

}  // namespace lober::detail
