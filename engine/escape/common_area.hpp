// What two closed curves have in common (private to escape/).
#pragma once

#include "engine/curve/curve.hpp"

namespace lober {

struct CommonArea {
  double area = 0, error = 0;
};

/// Of order h^6 where the polygons are simple; else by winding numbers, of the polygons, with an error bar of the
/// distance of the two orders that a smooth curve would show.
[[nodiscard]] CommonArea common_area(CurveView first, CurveView second);

/// The integral of the product of both winding numbers, |.|: for curves that may cross themselves, have corners and go
/// to and fro. Of the polygons with all vertices and with every second one; the error of polygons, which goes with the
/// square of the length of segments, is extrapolated away; the error bar is the whole difference of the two.
[[nodiscard]] CommonArea common_area_by_winding(CurveView first, CurveView second);

}  // namespace lober
