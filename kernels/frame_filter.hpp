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

/// Sorts the `count` nodes of `list`, of even levels, by which of the first `present` of `four` their frames may meet,
/// like distribute. A node is left out only if a line along one of the two frames, or one across the first, certainly
/// separates them. Frames that are not finite meet all.
void distribute_frames(const FourFrames& four, std::size_t present, FramePyramid pyramid, const TreeNode* list,
                       std::size_t count, const std::array<TreeNode*, nodes_at_once>& met,
                       std::array<std::size_t, nodes_at_once>& met_count);

/// The nodes of `list` that are leaves or no larger than `largest` (by frame_size) go to `kept`; of the nodes two
/// levels below the others, those whose frames may meet frame `which` of `four` go to `kept` likewise, or to `split`.
/// `size` has the number of nodes on each level. Room for 4 `count` + 1 is needed in both.
SplitCounts refine_frames(const FourFrames& four, std::size_t which, double largest, FramePyramid pyramid,
                          const std::uint32_t* size, const TreeNode* list, std::size_t count, TreeNode* kept,
                          TreeNode* split);

/// The measure of the size of a frame.
[[nodiscard]] LOBER_INLINE double frame_size(const FourFrames& four, std::size_t which) {
  return four.length[which] + four.width[which];
}

}  // namespace lober::detail
