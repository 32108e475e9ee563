// Pairs of nodes of trees, four side by side.
#pragma once

#include "kernels/box_pyramid.hpp"
#include "kernels/simd.hpp"

namespace lober::detail {
namespace {

// Four pairs.
using PairLanes = std::uint32_t __attribute__((vector_size(32)));
// Writes those of four pairs whose bits are set to `to`, one behind the other, and returns how many they are. All four
// places are written to.
inline std::size_t put_pairs(PairLanes four, unsigned bits, NodePair* to) {
#ifdef __AVX2__
  alignas(32) static constexpr std::uint32_t places[16][8] = {
      {0, 1, 2, 3, 4, 5, 6, 7}, {0, 1, 2, 3, 4, 5, 6, 7}, {2, 3, 0, 1, 4, 5, 6, 7}, {0, 1, 2, 3, 4, 5, 6, 7},
      {4, 5, 0, 1, 2, 3, 6, 7}, {0, 1, 4, 5, 2, 3, 6, 7}, {2, 3, 4, 5, 0, 1, 6, 7}, {0, 1, 2, 3, 4, 5, 6, 7},
      {6, 7, 0, 1, 2, 3, 4, 5}, {0, 1, 6, 7, 2, 3, 4, 5}, {2, 3, 6, 7, 0, 1, 4, 5}, {0, 1, 2, 3, 6, 7, 4, 5},
      {4, 5, 6, 7, 0, 1, 2, 3}, {0, 1, 4, 5, 6, 7, 2, 3}, {2, 3, 4, 5, 6, 7, 0, 1}, {0, 1, 2, 3, 4, 5, 6, 7}};
  PairLanes place;
  std::memcpy(&place, places[bits], sizeof place);
  four = reinterpret_cast<PairLanes>(
      _mm256_permutevar8x32_epi32(reinterpret_cast<__m256i>(four), reinterpret_cast<__m256i>(place)));
  std::memcpy(to, &four, sizeof four);
  return static_cast<std::size_t>(__builtin_popcount(bits));
#else
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < lanes; ++i) {
    to[count] = {four[2 * i], four[2 * i + 1]};
    count += bits >> i & 1U;
  }
  return count;
#endif
}

inline PairLanes four_times(NodePair pair) {
  return PairLanes{pair.first, pair.second, pair.first, pair.second, pair.first, pair.second, pair.first, pair.second};
}

// Pairs of nodes of two levels, replaced by those below the first ones or the second ones. The list of one node is
// short and of a length of its own, so that a loop for each would be left where nobody expects it: these go over those
// of all nodes of a level. `Pairs` says which may meet.
template <typename Pairs, bool splits_first, Keep keep>
SplitCounts split_pairs(typename Pairs::Level first, typename Pairs::Level second, const NodePair* pairs,
                        std::size_t count, NodePair* kept, NodePair* split) {
  constexpr PairLanes step = splits_first ? PairLanes{0, 0, 1, 0, 2, 0, 3, 0} : PairLanes{0, 0, 0, 1, 0, 2, 0, 3};
  const std::uint32_t nodes = splits_first ? first.nodes : second.nodes, last_four = (nodes - 1) / 4 * 4;
  const unsigned present = 15U >> (last_four + 4 - nodes);
  SplitCounts end{0, 0};
  for (std::size_t k = 0; k < count; ++k) {
    NodePair pair = pairs[k];
    Pairs four_pairs;
    if constexpr (splits_first) {
      four_pairs.first_by_four(first, second, pair);
    } else {
      four_pairs.second_by_four(first, second, pair);
    }
    std::uint32_t& divided = splits_first ? pair.first : pair.second;
    divided *= 4;
    unsigned meets = four_pairs.meet();
    if (divided == last_four) meets &= present;
    const PairLanes four = four_times(pair) + step;
    if constexpr (keep == Keep::all) {
      end.kept += put_pairs(four, meets, kept + end.kept);
    } else if constexpr (keep == Keep::none) {
      end.split += put_pairs(four, meets, split + end.split);
    } else {
      const unsigned small = meets & four_pairs.second_is_small();
      end.kept += put_pairs(four, small, kept + end.kept);
      end.split += put_pairs(four, meets ^ small, split + end.split);
    }
  }
  return end;
}

template <typename Pairs, bool splits_first>
inline SplitCounts split_pairs(typename Pairs::Level first, typename Pairs::Level second, const NodePair* pairs,
                               std::size_t count, Keep keep, NodePair* kept, NodePair* split) {
  switch (keep) {
    case Keep::all:
      return split_pairs<Pairs, splits_first, Keep::all>(first, second, pairs, count, kept, split);
    case Keep::none:
      return split_pairs<Pairs, splits_first, Keep::none>(first, second, pairs, count, kept, split);
    case Keep::level:
      break;
  }
  return split_pairs<Pairs, splits_first, Keep::level>(first, second, pairs, count, kept, split);
}

}  // namespace
}  // namespace lober::detail
