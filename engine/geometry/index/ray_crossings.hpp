// The one way in which a point is located with respect to a curve: crossings of a ray to the right, with sign.
#pragma once

#include <cstdint>

#include "engine/geometry/index/box_tree.hpp"

namespace lober::detail {

struct RayCrossings {
  std::int32_t number = 0;  ///< upward ones less downward ones: the winding number, for a closed curve
  bool on = false;          ///< the point lies on the curve; the number says nothing then
};

/// Exact. A box that the ray misses is skipped, one that lies wholly to the right of the point counts by the heights of
/// its two ends. About log N for a curve whose boxes overlap little.
[[nodiscard]] RayCrossings ray_crossings(const BoxTree& tree, Point point);

}  // namespace lober::detail
