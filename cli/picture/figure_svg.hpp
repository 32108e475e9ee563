// The one renderer: a figure as SVG, with title, axes, legend and labels, in the size in which it will be printed.
#pragma once

#include <optional>
#include <string>

#include "cli/picture/figure.hpp"

namespace lober::cli {

/// The choices that the options of pictures leave to users (picture_options.hpp).
struct FigureStyle {
  std::optional<Rectangle> window{};  ///< part of the plane that is shown; none: the figure's own
  std::optional<Rectangle> inset{};   ///< part that is shown once more, magnified
  double width = 85;                  ///< width of the picture in mm: a column of a journal
  std::optional<double> height{};     ///< in mm; none: as the window asks for
  bool legend = true;
  std::optional<std::string> title{};  ///< above the plot; none: the figure's own
};

/// The picture as SVG, the same bytes every time. Lines are cut to the window and simplified to a twentieth of a point;
/// coordinates are relative to the picture. O(points).
[[nodiscard]] std::string figure_svg(const Figure& figure, const FigureStyle& style);

/// A figure without the document around it, for pictures of several.
struct DrawnFigure {
  std::string elements;
  double width = 0, height = 0;  ///< in points of print
};
/// `frame_name`: of its plot, different for each figure of a picture.
[[nodiscard]] DrawnFigure draw_figure(const Figure& figure, const FigureStyle& style, const std::string& frame_name);
/// The document of a picture with this title.
[[nodiscard]] std::string svg_document(const std::string& title, const DrawnFigure& drawn);

}  // namespace lober::cli
