// What operations ask of the curves that they are given.
#pragma once

#include <string_view>

#include "lober/curve.hpp"

namespace lober::detail {

/// Throw UsageError "NAME is open; OPERATION needs closed curves", or the other way round. O(1).
void require_closed(CurveView curve, std::string_view name, std::string_view operation);
void require_open(CurveView curve, std::string_view name, std::string_view operation);

/// What every operation on regions asks of its curves: require_closed and require_enough_vertices.
void require_region(CurveView curve, std::string_view name, std::string_view operation);

}  // namespace lober::detail
