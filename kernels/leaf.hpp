// One streaming pass over a curve: everything that later stages need to know of a run of consecutive segments.
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernels/box.hpp"
#include "kernels/double_double.hpp"
#include "kernels/point.hpp"

namespace lober::detail {

/// Segments per leaf of the box tree.
inline constexpr std::size_t leaf_size = 32;

/// Set when *all* segments of a run go strictly the same way along an axis. Such a run cannot meet itself, and two
/// consecutive runs with a common flag together neither; decided by comparing coordinates, hence exactly.
enum MonotoneFlags : std::uint8_t {
  rises_in_x = 1,
  rises_in_y = 2,
  falls_in_x = 4,
  falls_in_y = 8,
};

/// Reads leaves [first, first + count) of a chain of points; leaf k has the segments k * leaf_size + (0 .. leaf_size -
/// 1), so points up to index (first + count) * leaf_size must exist (a caller pads by repeating the last one). For each
/// leaf:
///   box    of its leaf_size + 1 points
///   sum    sum of cross(v_i - o, v_{i+1} - o) over its segments, o the first point of the leaf: twice the signed area
///          between leaf and chord, in double-double, error below 2^-96 times the squared diameter of the leaf
///   flags  MonotoneFlags
/// O(count), about one pass at memory speed.
void summarise_leaves(const Point* points, std::size_t first, std::size_t count, Box* boxes, DD* sums,
                      std::uint8_t* flags);

}  // namespace lober::detail
