// Cells of a grid, as boxes along its rows.
#pragma once

#include <cstddef>
#include <vector>

#include "lober/curve/point.hpp"

namespace lober::cli {

/// A corner of a cell, of a grid that divides the window evenly.
[[nodiscard]] inline Point cell_corner(const Rectangle& window, std::size_t columns, std::size_t rows,
                                       std::size_t column, std::size_t row) {
  const auto along = [](double low, double high, std::size_t k, std::size_t cells) {
    const double fraction = static_cast<double>(k) / static_cast<double>(cells);
    return low * (1 - fraction) + high * fraction;
  };
  return {along(window.min_x, window.max_x, column, columns), along(window.min_y, window.max_y, row, rows)};
}

/// A box for each run of cells of a row for which has(column, row); corner(column, row) is a point of the plane.
template <typename Has, typename Corner>
[[nodiscard]] std::vector<Rectangle> cell_boxes(std::size_t columns, std::size_t rows, const Has& has,
                                                const Corner& corner) {
  std::vector<Rectangle> boxes;
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      if (!has(column, row)) continue;
      const std::size_t first = column;
      while (column < columns && has(column, row)) ++column;
      boxes.push_back(Rectangle::of(corner(first, row), corner(column, row + 1)));
    }
  }
  return boxes;
}

}  // namespace lober::cli
