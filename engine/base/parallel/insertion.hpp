// Few new elements into a long array, in one pass (private to densify/ and dynamics/).
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "engine/base/parallel/running_sums.hpp"

namespace lober::detail {

/// Puts each of `inserted` (ascending by `segment`) behind element `segment` of `given`: element k gets index k +
/// (number of insertions before it). `value(insertion)` is what is put there. O(given + inserted), parallel.
template <typename T, typename Insertion, typename Value>
Buffer<T> with_inserted(std::span<const T> given, const Buffer<Insertion>& inserted, const Value& value) {
  Buffer<T> result(given.size() + inserted.size());
  for_each_block(given.size(), pass_grain, [&](std::size_t first, std::size_t last) {
    std::size_t next = static_cast<std::size_t>(
        std::lower_bound(inserted.begin(), inserted.end(), first,
                         [](const Insertion& insertion, std::size_t vertex) { return insertion.segment < vertex; }) -
        inserted.begin());
    for (std::size_t k = first; k < last;) {
      const std::size_t end =
          next < inserted.size() ? std::min<std::size_t>(inserted[next].segment + std::size_t{1}, last) : last;
      std::copy(given.data() + k, given.data() + end, result.data() + k + next);
      k = end;
      for (; next < inserted.size() && inserted[next].segment + std::size_t{1} == k; ++next)
        result[k + next] = value(inserted[next]);
    }
  });
  return result;
}

}  // namespace lober::detail
