// Lines and polygons of the plane as paths: cut to what is seen, then simplified to what can be seen.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "cli/picture/view.hpp"

namespace lober::cli {

/// Coordinates in paths are whole numbers of these in a point of print, so that paths are short.
inline constexpr int path_units = 40;
[[nodiscard]] int path_unit(double points);

/// The parts of a line, as points of the picture, that lie in the view or up to `margin` beyond; computed in extended
/// precision. A point that is not finite parts the line.
[[nodiscard]] std::vector<std::vector<PrintPoint>> clipped_line(const View& view, std::span<const Point> line,
                                                                bool closed, double margin);
/// The part of a polygon there, with sides along that border where the polygon leaves it.
[[nodiscard]] std::vector<PrintPoint> clipped_polygon(const View& view, std::span<const Point> polygon, double margin);

/// Draws lines into the `d` of a path, leaving out points without which no line moves by more than `tolerance` sideways
/// (lober/drawing.hpp), and the rest of a line after the largest number of points.
class PathWriter {
 public:
  PathWriter(const View& view, double tolerance, std::size_t max_points)
      : view_(view), tolerance_(tolerance), points_left_(max_points) {}

  void add_polygon(std::span<const Point> polygon);  ///< nothing if it is less than three points
  /// Without what lies on top of what is drawn of the line before.
  void add_line(std::span<const Point> line, bool closed);

  [[nodiscard]] bool full() const { return full_; }  ///< points beyond max_points were left out
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  void draw(std::span<const PrintPoint> line, bool closed);

  const View& view_;
  double tolerance_;
  std::size_t points_left_;
  bool full_ = false;
  std::string path_;
};

/// The path that `draw(writer)` makes, with a tolerance at which `max_points` points are enough, a twentieth of a point
/// of print (a quarter of a pixel at 400 dots an inch) at first; where 2 points do not do, the end is left out.
template <typename Draw>
[[nodiscard]] std::string path_of(const View& view, std::size_t max_points, const Draw& draw) {
  for (double tolerance = 0.045;; tolerance *= 2) {
    PathWriter writer(view, tolerance, max_points);
    draw(writer);
    if (!writer.full() || tolerance > 2) return writer.path();
  }
}

}  // namespace lober::cli
