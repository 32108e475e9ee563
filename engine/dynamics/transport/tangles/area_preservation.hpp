// Whether a map preserves area, without which the formulas of transport say nothing (private to transport/).
#pragma once

#include "lober/planar_map.hpp"

namespace lober::detail {

/// By the determinant of the derivative at a saddle, to what its cancellation leaves of it. Throws DataError with the
/// factor if it does not.
void require_areas_preserved(const PlanarMap& map, Point saddle);

}  // namespace lober::detail
