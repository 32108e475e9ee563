// Whether a map preserves area, without which the formulas of transport say nothing (private to transport/).
#pragma once

#include "lober/dynamics/planar_map.hpp"

namespace lober::detail {

/// Checks the determinant of the derivative at a saddle, as far as cancellation allows. Throws DataError with the
/// factor if the map does not preserve area.
void require_areas_preserved(const PlanarMap& map, Point saddle);

}  // namespace lober::detail
