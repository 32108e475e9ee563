// Curves on cylinders as a person names them: periods as text, and closed curves that are none in the plane.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "lober/base/export.hpp"
#include "lober/curve/periods.hpp"
#include "lober/curve/point.hpp"

namespace lober {

/// Takes "x=1", "y=360", "x=2pi" or "x=pi" into `periods`. False, and nothing taken, where the text is something else
/// or the period is not positive and finite.
[[nodiscard]] LOBER_API bool take_period(std::string_view text, Periods& periods);

/// Throws DataError "spec: ..." for a closed curve that goes round a cylinder, which would be closed by a segment
/// across all of it. O(1).
LOBER_API void require_closed_in_the_plane(std::span<const Point> points, Periods periods, const std::string& spec);

}  // namespace lober
