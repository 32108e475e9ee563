// Curves of longitudes and latitudes, which are read as points of the plane.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "kernels/point.hpp"

namespace lober::detail {

struct Columns {
  std::string remark;                  ///< what there is to say about them; empty nearly always
  std::optional<bool> latitude_first;  ///< as the header names them
};

/// Of a curve of longitudes and latitudes in degrees, as the header of its file names them or as jumps by more than
/// half a turn show it where all other segments are short, the remark says in which order the columns are taken, that
/// areas are those of the plane, and where it crosses the date line; of columns named y and x, that these are taken as
/// x and y. O(N), parallel.
[[nodiscard]] Columns columns_of(std::string_view header, std::span<const Point> points);

}  // namespace lober::detail
