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

/// Frames of the nodes of a binary tree, of every second level from the leaves on: those of level l are frames[begin[l
/// / 2]] onwards.
struct FramePyramid {
  const FourFrames* frames;
  const std::uint32_t* begin;
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
  FramePyramid frames;
  const std::uint8_t* flags;  ///< MonotoneFlags, laid out like the boxes
  bool closed;
  bool stalls;  ///< whether nodes that are points have to be left out
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

/// Up to four nodes of an even level side by side, of which the first has a number divisible by four.
struct FramedNodes {
  const FourFrames* frames;
  TreeNode first;
  std::uint32_t present;
  std::uint32_t far;  ///< candidates that begin there are never left out for where they are
};

/// For each of the nodes, the nodes of even levels of the tree that its frame may meet, out of the `count` ones of
/// `list` and those below them: leaves, or such as are no larger than the node (in length and width together) if that
/// is none. Those of node i go to met[i], and met_count[i] says how many. A candidate is left out only if a line along
/// one of the two frames, or one across that of the node, certainly separates them, or for nothing_between. Frames that
/// are not finite meet all. Returns the number of frames tested, or 0 if there was not memory for more than `capacity`
/// nodes, at least `count` + 1, in each of met[0 .. 3].
std::size_t descend_frames(const SelfTree& tree, const FramedNodes& nodes, const TreeNode* list, std::size_t count,
                           const std::array<TreeNode*, nodes_at_once>& met, std::size_t capacity,
                           std::array<std::size_t, nodes_at_once>& met_count);

}  // namespace lober::detail
