// The common area of two closed curves that cross themselves (private to escape/).
#pragma once

#include <cstdint>

#include "lober/overlay/smooth.hpp"

namespace lober::detail {

struct CommonWindingArea {
  double area = 0, error = 0;
  std::uint64_t nodes = 0;  ///< nodes of the polygons with themselves and each other: the work
};

/// The integral of the product of both winding numbers, |.|: for curves that may cross themselves, have corners and go
/// to and fro. It is computed for the polygons with all vertices and with every second one; the error of polygons,
/// which goes with the square of the length of segments, is extrapolated away; the error bar is the whole difference of
/// the two, for either half of the vertices, or half of that to every fourth vertex where it is more.
[[nodiscard]] CommonWindingArea common_area_by_winding(const ClosedCurve& first, const ClosedCurve& second);

/// The integral of the winding number, |.|, in the same way, with no nodes.
[[nodiscard]] CommonWindingArea area_by_winding(const ClosedCurve& curve);

}  // namespace lober::detail
