// Requirements of operations on the curves that they are given.
#pragma once

#include <span>
#include <string_view>

#include "lober/curve/curve.hpp"

namespace lober::detail {

/// Throw UsageError "NAME is open; OPERATION needs closed curves", or the other way round. O(1).
void require_closed(CurveView curve, std::string_view name, std::string_view operation);
void require_open(CurveView curve, std::string_view name, std::string_view operation);

/// Whether a polygon that was made, not given, has as many distinct vertices as a closed curve needs: lobes next to a
/// saddle may shrink to a point. O(1) for all others.
[[nodiscard]] bool bounds_something(std::span<const Point> polygon);

/// The requirements of every operation on regions: require_closed and require_enough_vertices.
void require_region(CurveView curve, std::string_view name, std::string_view operation);

}  // namespace lober::detail
