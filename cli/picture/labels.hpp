// Labels of a plot: short texts with subscripts beside points or in regions, which never overlap each other.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "cli/picture/view.hpp"
#include "lober/curve/drawing.hpp"

namespace lober::cli {

/// Texts are those of add_text. A label that finds no room is left out. All lengths in points of print.
class Labels {
 public:
  /// Labels of the plot of this view.
  explicit Labels(const View& view);

  /// Lines and dots that labels should keep clear of, and what none may cover.
  void avoid_line(std::span<const PrintPoint> line);
  void avoid_dot(PrintPoint dot, double radius);
  void avoid_frame(const Frame& frame);

  /// Beside a dot; a thin line leads to it where the label is far away.
  void add_beside(PrintPoint dot, double radius, std::string_view text, double size);
  /// Where a polygon of the picture has most room; beside that position if it has none.
  void add_inside(std::span<const PrintPoint> polygon, std::string_view text, double size);
  /// Where the plot has most room outside the polygon.
  void add_outside(std::span<const PrintPoint> polygon, std::string_view text, double size);

  /// All labels as elements.
  [[nodiscard]] const std::string& drawn() const { return svg_; }

 private:
  [[nodiscard]] Point in_layout(PrintPoint at) const;
  [[nodiscard]] std::vector<Point> in_layout(std::span<const PrintPoint> line) const;
  void draw(const Rectangle& box, PrintPoint at, double radius, std::string_view text, double size);
  void put_where_roomiest(std::span<const Point> outline, std::string_view text, double size);

  Frame frame_;
  LabelLayout layout_;
  std::string svg_;
};

}  // namespace lober::cli
