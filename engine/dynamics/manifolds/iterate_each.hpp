// Images of points that are wanted after different numbers of steps.
#pragma once

#include <span>

#include "lober/dynamics/planar_map.hpp"

namespace lober::detail {

/// Replaces each point by its image under the number of steps that iterates holds for it. Neighbours with the same
/// number are followed together, which maps do faster. Serial.
inline void iterate_each(const PlanarMap& map, std::span<Point> points, std::span<const int> iterates) {
  for (std::size_t begin = 0, end = 0; begin < points.size(); begin = end) {
    while (end < points.size() && iterates[end] == iterates[begin]) ++end;
    map.iterate(points.subspan(begin, end - begin), iterates[begin]);
  }
}

}  // namespace lober::detail
