// Labels of a picture: short texts with subscripts beside points or in regions, which never overlap each other.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "cli/report/svg.hpp"
#include "lober/curve/drawing.hpp"

namespace lober::cli {

/// Texts are plain but for `_{...}`, a subscript, and `^{...}`, a superscript: "L_{12}(1)", "f^{-1}(q)". A label that
/// finds no room is left out.
class Labels {
 public:
  /// Labels of a plot of this view, margins included.
  explicit Labels(const View& view);

  /// Lines and dots that labels should keep clear of.
  void avoid(std::span<const Point> line);
  void avoid(Pixel dot, double radius);

  /// Beside a dot; a thin line leads to it where the label is far away.
  void add_beside(Pixel dot, double radius, std::string_view text, double size = 17);
  /// Where a polygon of the plane has most room; beside that place if it has none.
  void add_inside(std::span<const Point> polygon, std::string_view text, double size = 17);
  /// Where the plot has most room outside the polygon.
  void add_outside(std::span<const Point> polygon, std::string_view text, double size = 17);

  /// All labels as elements in pixels: after begin_legend.
  [[nodiscard]] const std::string& drawn() const { return svg_; }

 private:
  void draw(const Rectangle& box, Pixel at, double radius, std::string_view text, double size);

  const View& view_;
  LabelLayout layout_;
  std::string svg_;
};

}  // namespace lober::cli
