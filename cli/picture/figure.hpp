// A picture as its command describes it: axes, layers, labels. How it is drawn (figure_svg.hpp) and what is in it
// (figure_data.hpp) follow from that alone, so a command knows nothing of SVG.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "lober/curve/point.hpp"
#include "viewer/palette.hpp"

namespace lober::cli {

/// A line or a polygon of a layer: points of its own, or borrowed ones, which have to outlive the figure.
struct Polyline {
  std::vector<Point> own{};
  std::span<const Point> borrowed{};
  bool closed = false;
  std::string name{};    ///< what the data call it
  std::string colour{};  ///< where it is not that of its layer

  [[nodiscard]] std::span<const Point> points() const { return own.empty() ? borrowed : std::span<const Point>(own); }
};

/// How a layer is drawn.
enum class LayerKind : std::uint8_t { fill, line, dots, boxes };
enum class DotShape : std::uint8_t { circle, square, triangle, cross };

/// Things of one meaning, drawn together; layers cover those before them. Lengths are in points of print (1/72 inch).
struct Layer {
  LayerKind kind = LayerKind::line;
  std::string name{};    ///< in the data
  std::string legend{};  ///< empty: not in the legend
  std::string colour = palette::ink;
  double width = 0.6;    ///< width of lines
  double opacity = 0.4;  ///< opacity of fills
  bool even_odd = false, dashed = false;
  double arrows = 0;          ///< distance between heads of arrows along lines; 0: none
  bool arrow_at_end = false;  ///< one head, at the last point of each line
  DotShape shape = DotShape::circle;
  double radius = 1.4;
  bool hollow = false;             ///< dots
  std::vector<Polyline> lines{};   ///< lines, or outlines of fills
  std::vector<Point> points{};     ///< the dots
  std::vector<double> errors{};    ///< half the length of a bar of a dot along y; none, or one for each
  std::vector<Rectangle> boxes{};  ///< the boxes, opaque
  std::vector<double> values{};    ///< numbers that boxes stand for, in the data; none, or one for each
};

[[nodiscard]] inline Layer line_layer(std::string name, std::string legend, std::string colour, double width = 0.6) {
  return {.kind = LayerKind::line,
          .name = std::move(name),
          .legend = std::move(legend),
          .colour = std::move(colour),
          .width = width};
}
[[nodiscard]] inline Layer fill_layer(std::string name, std::string legend, std::string colour) {
  return {.kind = LayerKind::fill, .name = std::move(name), .legend = std::move(legend), .colour = std::move(colour)};
}
[[nodiscard]] inline Layer box_layer(std::string name, std::string legend, std::string colour) {
  return {.kind = LayerKind::boxes, .name = std::move(name), .legend = std::move(legend), .colour = std::move(colour)};
}
[[nodiscard]] inline Layer dot_layer(std::string name, std::string legend, std::vector<Point> points,
                                     double radius = 1.4) {
  return {.kind = LayerKind::dots,
          .name = std::move(name),
          .legend = std::move(legend),
          .radius = radius,
          .points = std::move(points)};
}

/// A short text in the plot. Plain but for `_{...}`, a subscript, and `^{...}`, a superscript: "L_{12}(1)".
struct FigureLabel {
  enum class Position : std::uint8_t { beside, inside, outside };
  Position position = Position::beside;
  std::string text{};
  Point at{};           ///< where `beside` is
  double radius = 1.5;  ///< radius of the dot there
  Polyline polygon{};   ///< where `inside` and `outside` are
  double size = 7.5;
};

struct Axis {
  std::string name;
  std::string unit{};          ///< empty: none
  bool whole_numbers = false;  ///< no ticks between them
  bool exponents = false;      ///< values are powers to which ten is raised: ticks say 10^k
  /// Names of 0, 1, 2, ..., which are ticks instead of numbers; as many as there is room for.
  std::vector<std::string> categories{};
};

struct Figure {
  std::string what{};   ///< what kind of picture it is: "Tangle of two manifolds"
  std::string title{};  ///< line above the plot: system and parameters
  Axis x{"x"}, y{"y"};
  bool plane = true;       ///< both axes have one scale, unless the window is far longer than wide
  bool axes = true;        ///< frame with ticks
  bool guides = true;      ///< lines at the ticks of y, where it is not a plane
  bool zero_line = false;  ///< a line along y = 0
  Rectangle window{};      ///< what is shown where no other window is asked for
  std::vector<Layer> layers{};
  std::vector<double> x_marks{};  ///< vertical lines
  std::vector<FigureLabel> labels{};
  std::vector<std::string> notes{};  ///< lines of the legend without a sample
};

/// The smallest box that holds these points, which are finite, and those of `box`.
[[nodiscard]] inline Rectangle include(const Rectangle& box, std::span<const Point> points) {
  Rectangle result = box;
  for (const Point& point : points) result.add(point);
  return result;
}

}  // namespace lober::cli
