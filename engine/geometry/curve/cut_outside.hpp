// A closed polygon without the parts far from a rectangle (private to engine/).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "lober/curve/curve.hpp"

namespace lober::detail {

/// As `clipped`, but segments that meet the rectangle stay whole, and so do `beside` more on either side of them: what
/// is fitted to vertices in a row is the same inside as along the whole polygon. The rest runs along the sides of the
/// rectangle, so that winding numbers inside are right. A polygon that nowhere meets the rectangle is clipped. O(N).
[[nodiscard]] std::vector<Point> cut_outside(std::span<const Point> polygon, const Rectangle& rectangle,
                                             std::size_t beside);

}  // namespace lober::detail
