// The box in which polygons have their area: thin ends of lobes may reach far beyond it.
#pragma once

#include <span>
#include <vector>

#include "lober/curve/point.hpp"

namespace lober::cli {

/// The box of all polygons or, where that is less than half as wide or as high, the one beyond each of whose sides lies
/// at most a hundredth of the sum of their areas. O(points).
[[nodiscard]] Rectangle area_box(std::span<const std::vector<Point>> polygons);

/// The part of a box that reaches beyond `core` by at most its own sides on each of them: lobes that are carried far
/// away do not shrink the region that they leave to a dot.
[[nodiscard]] Rectangle box_about(const Rectangle& core, const Rectangle& box);

}  // namespace lober::cli
