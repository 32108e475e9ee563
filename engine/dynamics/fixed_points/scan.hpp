// One scan of a box for fixed points.
#pragma once

#include <vector>

#include "engine/dynamics/fixed_points/displacement_grid.hpp"
#include "lober/fixed_points.hpp"

namespace lober::detail {

/// Throws UsageError for options or a box that make no sense.
void require_scan(const Rectangle& box, const FixedPointOptions& options);

/// What Newton's method finds in the box from the seeds of the grid, sorted by period, x, y.
[[nodiscard]] std::vector<FixedPoint> scan(const PlanarMap& map, const Rectangle& box, const FixedPointOptions& options,
                                           const DisplacementGrid& grid);

}  // namespace lober::detail
