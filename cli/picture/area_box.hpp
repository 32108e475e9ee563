// The box in which polygons have their area: thin ends of lobes may reach far beyond it.
#pragma once

#include <span>
#include <vector>

#include "lober/curve/point.hpp"

namespace lober::cli {

/// The box of all polygons or, where that is less than half as wide or as high, the one beyond each of whose sides lies
/// at most a hundredth of the sum of their areas. O(points).
[[nodiscard]] Rectangle area_box(std::span<const std::vector<Point>> polygons);

}  // namespace lober::cli
