// Lobes on a grid of cells: the `lobe.dat` of the published program.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lober/point.hpp"
#include "lober/tangle.hpp"

namespace lober::cli {

/// Which lobe the centre of each cell lies in: k + 1 for lobe k on the left of its arcs, -(k + 1) on their right, 0 for
/// none. Where lobes overlap the first one counts. A centre on the outline of a lobe lies not in it.
struct LobeRaster {
  static constexpr std::size_t side = 100;  ///< cells along x and along y
  Rectangle window;                         ///< fits the lobes, or the manifolds if there are none
  std::vector<int> lobes;                   ///< row by row from below, each from the left

  [[nodiscard]] Point centre(std::size_t column, std::size_t row) const;
};

/// Exact for the outlines as polygons; about 100 ns for each cell in the box of a lobe.
[[nodiscard]] LobeRaster rasterise(const Tangle& tangle);

/// As a Tecplot zone of 100 x 100 points in I, J order: x, y and the number.
void append_raster_zone(std::string& text, const LobeRaster& raster, const std::string& title);

}  // namespace lober::cli
