// Slanted rectangles, and which of many may meet a given one: what boxes cannot tell apart where folds run side by
// side.
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernels/box_pyramid.hpp"
#include "kernels/point.hpp"

namespace lober::detail {

/// The points that lie within `length` of `middle` along `along`, and within `width` beside it. `along` has length 1,
/// but for rounding. `length` and `width` contain what rounding may do to the tests below: 2^-47 of the coordinates of
/// `middle` and of the sizes.
struct Frame {
  Point middle;
  Point along;
  double length, width;
};

/// Frames of all nodes of a binary tree: those of level l are frames[begin[l]] onwards.
struct FramePyramid {
  const Frame* frames;
  const std::uint32_t* begin;
};

/// Keeps those of the `count` nodes of `list` whose frames may meet `frame`, in order; returns how many. A node goes
/// only if a line along its frame or along `frame` certainly separates the two. Frames that are not finite stay.
std::size_t keep_near(const Frame& frame, FramePyramid pyramid, TreeNode* list, std::size_t count);

}  // namespace lober::detail
