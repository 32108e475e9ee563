// Common parts of the pictures: a view of the plane, paths simplified to what can be seen, a legend.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/operations/picture_size.hpp"
#include "lober/curve/point.hpp"

namespace lober::cli {

/// A point of the picture, x to the right and y down.
using Pixel = Point;

inline constexpr double picture_width = detail::PictureSize{}.width;  ///< width of the plot, in pixels
inline constexpr double picture_margin = 24;
inline constexpr int subpixels = 20;  ///< coordinates in paths are whole numbers of these, so that paths are short
[[nodiscard]] int subpixel(double pixels);

/// The smallest box that holds these points and those of `box`.
[[nodiscard]] Rectangle include(const Rectangle& box, std::span<const Point> points);

/// From a window of the plane, y up, to pixels, y down. Both axes have one scale, unless the window is much longer than
/// wide.
class View {
 public:
  explicit View(const Rectangle& window);
  [[nodiscard]] Pixel operator()(Point point) const;
  [[nodiscard]] double height() const { return height_; }  ///< height of the plot
  [[nodiscard]] double left() const;                       ///< where the plot begins
  [[nodiscard]] double width() const { return plot_width_; }

 private:
  Point low_, half_;
  double height_ = picture_width, plot_width_ = picture_width;
};

/// Draws lines into the `d` of a path, leaving out points without which no line moves by more than `tolerance` pixels
/// sideways (lober/drawing.hpp), and the rest of a line after its largest number of points.
class PathWriter {
 public:
  PathWriter(const View& view, double tolerance, std::size_t max_points)
      : view_(view), tolerance_(tolerance), points_left_(max_points) {}

  void add_polygon(std::span<const Point> polygon);  ///< nothing if it is less than three points
  /// Only the parts that lie in the picture and not on top of what is drawn of the line before.
  void add_line(std::span<const Point> line);

  [[nodiscard]] bool full() const { return full_; }  ///< points beyond max_points were left out
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  void draw(std::span<const Pixel> line, bool closed);

  const View& view_;
  double tolerance_;
  std::size_t points_left_;
  bool full_ = false;
  std::string path_;
};

/// The path that `draw(writer)` makes, with a tolerance at which `max_points` points are enough; where 8 pixels do not
/// do, the end is left out.
template <typename Draw>
[[nodiscard]] std::string path_of(const View& view, std::size_t max_points, const Draw& draw) {
  for (double tolerance = 0.1;; tolerance *= 2) {
    PathWriter writer(view, tolerance, max_points);
    draw(writer);
    if (!writer.full() || tolerance > 8) return writer.path();
  }
}

// Largest numbers of points of a path.
inline constexpr std::size_t max_path_points = 200'000;
inline constexpr std::size_t max_manifold_path_points =
    14'000;  ///< points of manifolds: five paths stay below a megabyte

[[nodiscard]] std::string polygon_path(const View& view, std::span<const Point> polygon, std::size_t max_points);
[[nodiscard]] std::string line_path(const View& view, std::span<const Point> line, std::size_t max_points);

/// Opens the picture of a plot with `lines` lines of legend; then come elements in subpixels. `clipped`: nothing is
/// seen beyond the plot, for windows that curves leave.
void begin_picture(std::string& svg, const View& view, std::string_view title, int legend_lines, bool clipped = false);
void add_filled(std::string& svg, std::string_view colour, std::string_view rule, const std::string& path);
void add_stroked(std::string& svg, std::string_view colour, double pixels, const std::string& path);
void add_dot(std::string& svg, Pixel at, double radius);
/// A head of this length whose apex is at `apex`, for a line that comes from `from`; nothing where both are the same.
void add_arrow_head(std::string& svg, Pixel from, Pixel apex, double length, std::string_view colour);

/// Ends the plot; then come the entries of the legend.
void begin_legend(std::string& svg);
[[nodiscard]] std::string line_swatch(std::string_view colour, double pixels);
[[nodiscard]] std::string filled_swatch(std::string_view colour);
[[nodiscard]] std::string opaque_swatch(std::string_view colour);
/// `column` 0 or 1; `line` from 0.
void add_legend_entry(std::string& svg, const View& view, int column, int line, std::string_view swatch,
                      std::string_view text);
void end_picture(std::string& svg);

/// The text of an element, with entities for the characters that have a meaning in SVG.
[[nodiscard]] std::string escaped(std::string_view text);

/// A number with six digits.
[[nodiscard]] std::string rounded(double value);

}  // namespace lober::cli
