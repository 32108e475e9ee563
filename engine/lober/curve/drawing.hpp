// Curves and lobes for pictures: fewer points that look the same, cells that are drawn on once, points and lobes on a
// grid, positions for labels.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "lober/base/buffer.hpp"
#include "lober/base/export.hpp"
#include "lober/curve/point.hpp"
#include "lober/tangle/tangle.hpp"

namespace lober {

/// The rectangle with `fraction` of its width more on the left and on the right, and of its height below and above.
[[nodiscard]] LOBER_API Rectangle widened(const Rectangle& rectangle, double fraction);

/// The centres of the cells of a grid that divides the window into columns x rows, row by row from below, each from the
/// left. O(columns rows), parallel.
[[nodiscard]] LOBER_API Buffer<Point> cell_centres(const Rectangle& window, std::size_t columns, std::size_t rows);

/// Some of the points of a line, first and last among them, such that the others lie no further than sqrt(2) times
/// `tolerance` from the line through those (sideways no further than `tolerance`). O(N), in one pass: from each point
/// kept goes the cone of directions in which the line past all later points may go on. For curves whose areas matter
/// there is `simplify`.
[[nodiscard]] LOBER_API std::vector<Point> simplified_line(std::span<const Point> line, double tolerance);

/// Which square cells of a frame from (0, 0) on have been drawn on, so that lines on top of each other are drawn once.
class Coverage {
 public:
  /// A frame of this size with square cells of side `cell`.
  LOBER_API Coverage(double width, double height, double cell);

  /// Marks the cells on the segment and returns whether any of them is new. Takes steps of a cell's size, at most one a
  /// cell.
  LOBER_API bool mark(Point a, Point b);

 private:
  double cell_;
  std::size_t columns_, rows_;
  std::vector<bool> marked_;
};

/// Free space of a frame from (0, 0) on, on square cells. Lines are kept clear as far as there is room; labels and
/// blocked rectangles always are.
class LabelLayout {
 public:
  /// All lengths in pixels.
  LOBER_API LabelLayout(double width, double height);

  /// Labels avoid the segment; cells beyond the frame do not count.
  LOBER_API void add_line(Point a, Point b);
  /// No label covers any of this rectangle.
  LOBER_API void block(const Rectangle& rectangle);

  /// The result of roomiest.
  struct FreePlace {
    Point at;             ///< centre of the cell
    double distance = 0;  ///< distance to what it avoids
  };
  /// Inside a closed polygon (even-odd rule): the centre of the cell farthest from lines, labels, frame and the
  /// polygon's outside, distances across counted `flat` times, and that distance; none where no centre of a cell lies
  /// inside. O(cells).
  [[nodiscard]] LOBER_API std::optional<FreePlace> roomiest(std::span<const Point> polygon, double flat = 1) const;

  /// The box of a label of this size about `at`, or, where that covers lines, as near as possible; the box is blocked
  /// from now on. None where no position in the frame is free of other labels within `reach`.
  [[nodiscard]] LOBER_API std::optional<Rectangle> put_about(Point at, double width, double height, double reach = 150);
  /// The box of a label beside a dot of `radius`, otherwise the same.
  [[nodiscard]] LOBER_API std::optional<Rectangle> put_beside(Point at, double radius, double width, double height,
                                                              double reach = 150);

 private:
  [[nodiscard]] std::size_t cell_of(double coordinate, std::size_t cells) const;
  [[nodiscard]] bool free(const Rectangle& box) const;
  [[nodiscard]] std::size_t lines_below(const Rectangle& box) const;

  double width_, height_;
  std::size_t columns_, rows_;
  std::vector<unsigned char> lines_;
  std::vector<Rectangle> blocked_;
};

/// Which lobe the centre of each cell lies in: k + 1 for lobe k on the left of its arcs, -(k + 1) on their right, 0 for
/// none. Where lobes overlap the first one counts. A centre on the outline of a lobe does not lie in it.
struct LobeRaster {
  static constexpr std::size_t side = 100;  ///< cells along x and along y
  Rectangle window;                         ///< fits the lobes, or the manifolds if there are none
  std::vector<int> lobes;                   ///< row by row from below, each from the left

  /// The centre of a cell.
  [[nodiscard]] LOBER_API Point centre(std::size_t column, std::size_t row) const;
};

/// Exact for the outlines as polygons; about 100 ns for each cell in the box of a lobe. Parallel.
[[nodiscard]] LOBER_API LobeRaster rasterise(const Tangle& tangle);

}  // namespace lober
