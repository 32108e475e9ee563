// The size of a picture of a box, from which grids of cells follow that look square in it (private to operations/ and
// to the pictures of the program).
#pragma once

#include <algorithm>

#include "lober/curve/point.hpp"

namespace lober::detail {

/// The size of the plot, in pixels.
struct PictureSize {
  double width = 960, height = 960;
};

/// The size with the proportions of the box, except for boxes far longer than wide or wider than long.
[[nodiscard]] inline PictureSize picture_size(const Rectangle& box) {
  constexpr double full = PictureSize{}.width, min_aspect = 0.5, max_aspect = 1.25;  // height to width
  // Halves, because a difference of two finite numbers need not be finite.
  const double half_x = 0.5 * box.max_x - 0.5 * box.min_x, half_y = 0.5 * box.max_y - 0.5 * box.min_y;
  const double aspect = half_x > 0 ? half_y / half_x : 1;
  const double height = full * std::clamp(aspect, min_aspect, max_aspect);
  return {aspect > max_aspect && aspect < 4 ? height / aspect : full, height};
}

}  // namespace lober::detail
