// Nodes of a tree, four side by side.
#pragma once

#include "kernels/box_pyramid.hpp"
#include "kernels/simd.hpp"

namespace lober::detail {
namespace {

// Four nodes in a row, from `first` on.
using NodeLanes = std::uint32_t __attribute__((vector_size(32)));
inline NodeLanes nodes_from(TreeNode first) {
  const auto [level, index] = first;
  return NodeLanes{level, index, level, index, level, index, level, index} + NodeLanes{0, 0, 0, 1, 0, 2, 0, 3};
}
// Writes those of four nodes whose bits are set to `to`, one behind the other, and returns how many they are. All four
// places are written to.
template <typename Node>
inline std::size_t put_nodes(NodeLanes four, unsigned bits, Node* to) {
#ifdef __AVX2__
  alignas(32) static constexpr std::uint32_t places[16][8] = {
      {0, 1, 2, 3, 4, 5, 6, 7}, {0, 1, 2, 3, 4, 5, 6, 7}, {2, 3, 0, 1, 4, 5, 6, 7}, {0, 1, 2, 3, 4, 5, 6, 7},
      {4, 5, 0, 1, 2, 3, 6, 7}, {0, 1, 4, 5, 2, 3, 6, 7}, {2, 3, 4, 5, 0, 1, 6, 7}, {0, 1, 2, 3, 4, 5, 6, 7},
      {6, 7, 0, 1, 2, 3, 4, 5}, {0, 1, 6, 7, 2, 3, 4, 5}, {2, 3, 6, 7, 0, 1, 4, 5}, {0, 1, 2, 3, 6, 7, 4, 5},
      {4, 5, 6, 7, 0, 1, 2, 3}, {0, 1, 4, 5, 6, 7, 2, 3}, {2, 3, 4, 5, 6, 7, 0, 1}, {0, 1, 2, 3, 4, 5, 6, 7}};
  NodeLanes place;
  std::memcpy(&place, places[bits], sizeof place);
  four = reinterpret_cast<NodeLanes>(
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

}  // namespace
}  // namespace lober::detail
