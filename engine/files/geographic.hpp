// Curves of longitudes and latitudes, which are read as points of the plane.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "kernels/point.hpp"
#include "lober/curve/curve.hpp"

namespace lober::detail {

/// Whether a header names latitude and longitude, in that order; nothing where it does not name both.
[[nodiscard]] std::optional<bool> latitude_first(std::string_view header);

/// The remarks about the columns of a curve; nearly always empty.
struct ColumnsRemark {
  /// For longitudes and latitudes in degrees, as the header of its file names them or as jumps by more than half a turn
  /// show it where all other segments are short, it says in which order they are taken, that areas are those of the
  /// plane, and the warning with its remedy; for columns named y and x, that these are taken as x and y.
  std::string text;
  /// Where such a curve runs back across the whole map, as one across the date line does when its longitudes are those
  /// from -180 to 180, or one across the meridian of 0 when they are those from 0 to 360: "its segment 3 runs back
  /// ...".
  std::string warning;
};
/// O(N), parallel.
[[nodiscard]] ColumnsRemark columns_remark(std::string_view header, std::span<const Point> points);

}  // namespace lober::detail
