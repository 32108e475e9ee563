// Curves of longitudes and latitudes, which are read as points of the plane.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "kernels/point.hpp"

namespace lober::detail {

/// Whether a header names latitude and longitude, in that order; nothing where it does not name both.
[[nodiscard]] std::optional<bool> latitude_first(std::string_view header);

/// A remark about the columns of a curve; nearly always empty. For longitudes and latitudes in degrees, as the header
/// of its file names them or as jumps by more than half a turn show it where all other segments are short, it says in
/// which order they are taken, that areas are those of the plane, and where the curve crosses the date line; for
/// columns named y and x, that these are taken as x and y. O(N), parallel.
[[nodiscard]] std::string columns_remark(std::string_view header, std::span<const Point> points);

}  // namespace lober::detail
