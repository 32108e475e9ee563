// What two closed curves that cross themselves have in common (private to escape/).
#pragma once

#include "lober/smooth.hpp"

namespace lober::detail {

/// The integral of the product of both winding numbers, |.|: for curves that may cross themselves, have corners and go
/// to and fro. Of the polygons with all vertices and with every second one; the error of polygons, which goes with the
/// square of the length of segments, is extrapolated away; the error bar is the whole difference of the two, or half of
/// that to every fourth vertex where it is more.
[[nodiscard]] CommonArea common_area_by_winding(const ClosedCurve& first, const ClosedCurve& second);

}  // namespace lober::detail
