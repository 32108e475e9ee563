// A ray from a point to the right, through a tree of boxes and past the segments of a leaf: the inner loops of winding
// numbers.
//
// Heights are half-open: a vertex at the height of the point counts as below it, so that each crossing belongs to one
// segment.
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernels/box_pyramid.hpp"
#include "kernels/leaf.hpp"
#include "kernels/point.hpp"

namespace lober::detail {

/// A tree over the leaves of a curve: leaf k begins at begins[k] and ends where the next one begins.
struct RayTree {
  BoxPyramid boxes;
  const Point* begins;
  std::uint32_t leaves;
};

/// Room in a list of nodes for follow_ray, and how many it takes.
inline constexpr std::size_t ray_room = 256, ray_nodes = ray_room / nodes_at_once - 1;

/// How far a ray was followed.
struct RayProgress {
  std::uint32_t level = 0;  ///< level of the nodes that are left
  std::size_t count = 0;    ///< how many
  std::int32_t number = 0;  ///< upward crossings less downward ones of those that went
};

/// Goes on from the `count` nodes of `level` that `list` holds by number, at most ray_nodes, to those below them whose
/// boxes a ray from `point` to the right meets. Nodes that lie wholly to the right of the point are counted by the
/// heights of their two ends; the others stay in the list, until they are leaves or more than ray_nodes. `list` has
/// ray_room entries.
RayProgress follow_ray(Point point, const RayTree& tree, std::uint32_t level, std::uint32_t* list, std::size_t count);

/// Where the segments of a leaf pass the height of a point. Segment i is bit 2 i + 1 of a word.
struct HeightCrossings {
  std::int32_t number = 0;         ///< upward ones less downward ones, of segments wholly to the right
  std::uint64_t up = 0, down = 0;  ///< crossings by segments with an end on either side of the point, or above it
  std::uint64_t level = 0;         ///< an end is at the height, and the height is not crossed
};
/// For the leaf_size segments between the leaf_size + 1 points.
HeightCrossings crossings_of_height(const Point* points, Point point);

}  // namespace lober::detail
