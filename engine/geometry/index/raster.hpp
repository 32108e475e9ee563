// The cells of a uniform grid that a segment passes through (private to this folder: the grid and the chooser).
//
// The invariant: two segments with a point in common have a cell in common. Every real point has one
// well-defined cell, because coordinate -> column is a monotone function even as rounded; so the columns of a
// segment are exactly those from the column of its left end to that of its right end. Inside a column the
// rows are found by interpolation along the segment, widened by more than its rounding error.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "engine/geometry/index/box_tree.hpp"
#include "kernels/box.hpp"

namespace lober::detail {

/// A grid of columns x rows cells over a window. Cells are numbered row by row.
class Raster {
 public:
  Raster(const Box& window, std::uint32_t columns, std::uint32_t rows)
      : window_(window),
        x_{window.min_x(), scale(window.width(), columns), usable(window.width()) ? columns : 1},
        y_{window.min_y(), scale(window.height(), rows), usable(window.height()) ? rows : 1} {}

  /// A grid over the window for the segments of a curve that meet it: about two entries a cell, shaped so
  /// that the segments cross as few borders as they can, coarse enough that `max_entries` are not likely to
  /// be exceeded. Looks at `sample` leaves of the tree, evenly spread.
  static Raster fitted(const BoxTree& tree, const Box& window, std::uint64_t max_entries, std::size_t sample);

  /// Halves the number of columns and rows.
  [[nodiscard]] Raster coarser() const { return {window_, std::max(x_.cells / 2, 1U), std::max(y_.cells / 2, 1U)}; }
  [[nodiscard]] std::size_t cells() const { return std::size_t{x_.cells} * y_.cells; }
  [[nodiscard]] const Box& window() const { return window_; }

  /// Whether a window of this extent can be divided without overflow of any intermediate result.
  static bool usable(double extent) { return extent >= 0x1p-900 && extent <= 0x1p1000; }

  /// Calls visit(cell) once for each cell that the part of segment a b in the window may have a point in.
  template <typename Visit>
  void for_each_cell(Point a, Point b, const Visit& visit) const {
    const Box box = Box::of(a, b);
    if (!meet(box, window_)) return;
    const std::uint32_t left = x_.cell(std::max(box.min_x(), window_.min_x()));
    const std::uint32_t right = x_.cell(std::min(box.max_x(), window_.max_x()));
    const std::uint32_t bottom = y_.cell(std::max(box.min_y(), window_.min_y()));
    const std::uint32_t top = y_.cell(std::min(box.max_y(), window_.max_y()));
    if (left == right || bottom == top) {
      for (std::uint32_t row = bottom; row <= top; ++row) {
        for (std::uint32_t column = left; column <= right; ++column) visit(number(column, row));
      }
      return;
    }
    const double u0 = x_.in_cells(a.x), u1 = x_.in_cells(b.x), v0 = y_.in_cells(a.y), v1 = y_.in_cells(b.y);
    if (std::fabs(u1 - u0) >= std::fabs(v1 - v0)) {
      step(u0, u1, v0, v1, left, right, bottom, top, [&](auto column, auto row) { visit(number(column, row)); });
    } else {
      step(v0, v1, u0, u1, bottom, top, left, right, [&](auto row, auto column) { visit(number(column, row)); });
    }
  }

 private:
  struct Axis {
    double begin;
    double scale;  // cells per unit, 0 when all is one cell
    std::uint32_t cells;

    // In units of cells; right to 2^-51 relative. Infinite or NaN for ends far outside of an extreme window.
    [[nodiscard]] double in_cells(double coordinate) const { return scale == 0 ? 0 : (coordinate - begin) * scale; }
    [[nodiscard]] std::uint32_t cell(double coordinate) const {
      return static_cast<std::uint32_t>(std::min(in_cells(coordinate), static_cast<double>(cells - 1)));
    }
  };

  static double scale(double extent, std::uint32_t cells) {
    return usable(extent) ? static_cast<double>(cells) / extent : 0;
  }
  [[nodiscard]] std::size_t number(std::uint32_t column, std::uint32_t row) const {
    return std::size_t{row} * x_.cells + column;
  }

  // Steps along the axis u in which the segment is longer. An error e of u or v anywhere moves the
  // interpolated v by less than 8 e, because |dv| <= |du|; e < 2^-50 times the largest number, and the margin
  // is 16 times as much.
  template <typename Visit>
  static void step(double u0, double u1, double v0, double v1, std::uint32_t first, std::uint32_t last,
                   std::uint32_t low, std::uint32_t high, const Visit& visit) {
    const double largest = std::max({std::fabs(u0), std::fabs(u1), std::fabs(v0), std::fabs(v1),
                                     static_cast<double>(last) + 1, static_cast<double>(high) + 1});
    const double margin = largest * 0x1p-43;
    const double slope = (v1 - v0) / (u1 - u0);
    if (!(margin < 1) || !std::isfinite(slope)) {  // ends so far away that interpolation tells nothing
      for (std::uint32_t u = first; u <= last; ++u) {
        for (std::uint32_t v = low; v <= high; ++v) visit(u, v);
      }
      return;
    }
    const double v_min = std::min(v0, v1), v_max = std::max(v0, v1);
    for (std::uint32_t u = first; u <= last; ++u) {
      const double enter = std::clamp(v0 + (u - u0) * slope, v_min, v_max);
      const double leave = std::clamp(v0 + (u + 1.0 - u0) * slope, v_min, v_max);
      const double from = std::max(std::floor(std::min(enter, leave) - margin), static_cast<double>(low));
      const double to = std::min(std::floor(std::max(enter, leave) + margin), static_cast<double>(high));
      if (from > to) continue;
      const auto end = static_cast<std::uint32_t>(to);
      for (auto v = static_cast<std::uint32_t>(from); v <= end; ++v) visit(u, v);
    }
  }

  Box window_;
  Axis x_, y_;
};

/// Entries that a grid may have for curves of `segments` segments together: memory stays proportional to them.
[[nodiscard]] std::uint64_t max_grid_entries(std::size_t segments);

}  // namespace lober::detail
