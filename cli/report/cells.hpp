// Cells of a grid in a picture, as rectangles along its rows.
#pragma once

#include <cstddef>
#include <string>

#include "cli/report/svg.hpp"
#include "cli/report/text.hpp"

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

/// Calls add(row, first, end) for each run of cells of a row, from column `first` to before `end`, for which
/// has(column, row).
template <typename Has, typename Add>
void for_runs_of_cells(std::size_t columns, std::size_t rows, const Has& has, const Add& add) {
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      if (!has(column, row)) continue;
      const std::size_t first = column;
      while (column < columns && has(column, row)) ++column;
      add(row, first, column);
    }
  }
}

/// The runs of cells for which has(column, row), as the `d` of a path; corner(column, row) is a point of the plane.
template <typename Has, typename Corner>
[[nodiscard]] std::string cells_path(const View& view, std::size_t columns, std::size_t rows, const Has& has,
                                     const Corner& corner) {
  std::string path;
  for_runs_of_cells(columns, rows, has, [&](std::size_t row, std::size_t first, std::size_t end) {
    const Pixel low = view(corner(first, row)), high = view(corner(end, row + 1));
    const int x = subpixel(low.x), y = subpixel(low.y), width = subpixel(high.x) - x;
    append_all(path, "M", x, " ", y, "h", width, "v", subpixel(high.y) - y, "h", -width, "z");
  });
  return path;
}

}  // namespace lober::cli
