// Slanted rectangles, and which of many may meet given ones: what boxes cannot tell apart where folds run side by side.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "kernels/box_pyramid.hpp"
#include "kernels/inline.hpp"
#include "kernels/leaf.hpp"
#include "kernels/point.hpp"

namespace lober::detail {

/// Four frames side by side, those of nodes 4 k to 4 k + 3 of a level. A frame is the points that lie within `length`
/// of (x, y) along a direction, and within `width` beside it. The direction has length 1, but for rounding. `length`
/// and `width` contain what rounding may do to the tests below: 2^-47 of the coordinates and of the sizes.
struct alignas(32) FourFrames {
  double x[4], y[4];
  double along_x[4], along_y[4];
  double length[4], width[4];
};
static_assert(nodes_at_once == 4);

/// The frames of all nodes of a level, four by four, and how many they are.
struct FramedLevel {
  const FourFrames* frames;
  std::uint32_t nodes;
};

/// The frames of four leaves, along their chords, from their leaf_size + 1 points and their boxes.
void frames_of_leaves(const std::array<const Point*, nodes_at_once>& points,
                      const std::array<const Box*, nodes_at_once>& boxes, FourFrames& frames);

/// The ends of a run of segments.
struct Chord {
  Point from, to;
};
/// The frames of four nodes, along their chords, from those of four nodes below each and from their boxes. Where less
/// than four lie below a node, some of them come several times.
void join_frames(const std::array<const FourFrames*, nodes_at_once>& below,
                 const std::array<Chord, nodes_at_once>& chords, const std::array<const Box*, nodes_at_once>& boxes,
                 FourFrames& frames);

/// A tree that is searched for what its curve has in common with itself.
struct SelfTree {
  BoxPyramid boxes;
  const std::uint8_t* flags;  ///< MonotoneFlags, laid out like the boxes
  bool closed;
  [[nodiscard]] LOBER_INLINE std::uint32_t leaves() const { return boxes.size[0]; }
  [[nodiscard]] LOBER_INLINE std::uint8_t flags_of(TreeNode node) const {
    return flags[boxes.begin[node.level] + node.index];
  }
};

/// Whether there is nothing to find between two nodes of it: the pair is found the other way round, or both are one
/// monotone run.
[[nodiscard]] LOBER_INLINE bool nothing_between(const SelfTree& tree, TreeNode node, TreeNode candidate) {
  const std::uint32_t begin = node.index << node.level, end = (node.index + 1) << node.level;
  const std::uint32_t other_begin = candidate.index << candidate.level;
  const std::uint32_t other_end = (candidate.index + 1) << candidate.level;
  if (other_end <= begin) return true;
  const bool wraps = begin == 0 && other_end >= tree.leaves() && tree.closed;
  // One may contain the other, and then the larger is the run.
  if (other_begin > end && !wraps) return false;
  return (tree.flags_of(node) & tree.flags_of(candidate)) != 0;
}

/// The leaf from which on candidates are so far behind the nodes from `first` to `last` that nothing_between is false.
[[nodiscard]] LOBER_INLINE std::uint32_t far_behind(TreeNode first, TreeNode last) {
  return first.index == 0 ? ~std::uint32_t{0} : ((last.index + 1) << last.level) + 1;
}

/// The pairs of the four nodes below each first one with the second one, and the other way round, of which the frames
/// may meet. A pair is left out only if a line along one of the two frames, or one across the first, certainly
/// separates them: frames that are not finite meet all. `first` and `second` are the levels of the pairs that come out.
/// Room for 4 `count` + 4 is needed in `kept` and in `split`.
SplitCounts pairs_below_first(FramedLevel first, FramedLevel second, const NodePair* pairs, std::size_t count,
                              Keep keep, NodePair* kept, NodePair* split);
SplitCounts pairs_below_second(FramedLevel first, FramedLevel second, const NodePair* pairs, std::size_t count,
                               Keep keep, NodePair* kept, NodePair* split);

}  // namespace lober::detail
