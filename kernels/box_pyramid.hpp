// Pairs of tree nodes whose boxes meet: the inner loops of a walk of two box trees against each other.
//
// Whether boxes meet is as good as random there, so nothing branches on it: every candidate is written to the end of
// the list, which grows by one or by nothing.
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernels/box.hpp"

namespace lober::detail {

/// A node: level 0 are the leaves; node k of level l covers leaves [k << l, (k + 1) << l).
struct TreeNode {
  std::uint32_t level;
  std::uint32_t index;
  friend bool operator==(const TreeNode&, const TreeNode&) = default;
};

/// Boxes of all nodes of a binary tree: those of level l are boxes[begin[l]] onwards, size[l] of them. Three boxes
/// behind the last must be readable.
struct BoxPyramid {
  const Box* boxes;
  const std::uint32_t* begin;
  const std::uint32_t* size;
};

/// Nodes are replaced by those this number of levels below them, as far as there are levels.
inline constexpr std::uint32_t levels_at_once = 2;
inline constexpr std::size_t nodes_at_once = std::size_t{1} << levels_at_once;

/// The numbers of pairs that went to each list.
struct SplitCounts {
  std::size_t kept = 0;
  std::size_t split = 0;
};

/// Two nodes of two trees, or of one, by their numbers in their levels.
struct NodePair {
  std::uint32_t first, second;
  friend bool operator==(const NodePair&, const NodePair&) = default;
};

/// Which pairs are to be kept as they are; the others are to be split.
enum class Keep {
  all,
  none,
  level,  ///< those of which the second is at most as large as the first
};

/// The boxes of all nodes of a level, and how many they are. Three boxes behind the last must be readable.
struct BoxLevel {
  const Box* boxes;
  std::uint32_t nodes;
};
/// The pairs of the four nodes below each first one with the second one, and the other way round, of which the boxes
/// meet. `first` and `second` are the levels of the pairs that come out. Sizes are extents. Room for 4 `count` + 4 is
/// needed in `kept` and in `split`.
SplitCounts pairs_below_first(BoxLevel first, BoxLevel second, const NodePair* pairs, std::size_t count, Keep keep,
                              NodePair* kept, NodePair* split);
SplitCounts pairs_below_second(BoxLevel first, BoxLevel second, const NodePair* pairs, std::size_t count, Keep keep,
                               NodePair* kept, NodePair* split);

}  // namespace lober::detail
