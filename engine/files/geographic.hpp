// Curves of longitudes and latitudes, which are read as points of the plane.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "kernels/point.hpp"

namespace lober::detail {

/// What there is to say about a curve of longitudes and latitudes in degrees, as the header of its file names them or
/// as jumps by more than half a turn show it where all other segments are short: in which order the columns are taken,
/// that areas are those of the plane, and where it crosses the date line. Empty for other curves. O(N), parallel.
[[nodiscard]] std::string geographic_remark(std::string_view header, std::span<const Point> points);

}  // namespace lober::detail
