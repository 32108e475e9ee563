#include <algorithm>
#include <cmath>

#include "bench/accuracy/accuracy.hpp"
#include "cli/picture/panels.hpp"

namespace lober::bench {
namespace {

using cli::Figure;
using cli::Layer;

constexpr double smallest_error = 1e-17;  // an error of 0 is drawn here
constexpr double two_columns = 170;       // of a journal, in mm

Figure figure_of(const AccuracyPanel& panel, const PlotTexts& texts) {
  Figure figure{.what = panel.title, .title = panel.title};
  figure.plane = false;
  figure.x = {.name = texts.x, .unit = "s", .exponents = true};
  figure.y = {.name = texts.y, .exponents = true};
  Rectangle box;
  for (const AccuracyCurve& curve : panel.curves) {
    Layer line = cli::line_layer(curve.method, "", std::string(curve.style.colour), 0.8);
    std::vector<Point> points;
    for (const AccuracyPoint& point : curve.points) {
      points.push_back({std::log10(point.seconds), std::log10(std::max(point.error, smallest_error))});
      box.add(points.back());
    }
    Layer dots = cli::dot_layer(curve.method, curve.method, points, 1.3);
    dots.colour = curve.style.colour;
    dots.shape = curve.style.shape;
    line.lines.push_back({.own = std::move(points)});
    figure.layers.push_back(std::move(line));
    figure.layers.push_back(std::move(dots));
  }
  if (!box.empty()) {
    figure.window = {std::floor(box.min_x), std::floor(box.min_y), std::ceil(box.max_x), std::ceil(box.max_y)};
  }
  return figure;
}

}  // namespace

void write_plot(std::ostream& stream, const std::vector<AccuracyPanel>& panels, const PlotTexts& texts) {
  std::vector<Figure> figures;
  for (const AccuracyPanel& panel : panels) figures.push_back(figure_of(panel, texts));
  if (!figures.empty()) figures.back().notes.push_back(texts.note);
  stream << cli::panels_svg("Run time against error", figures, 2, {.width = two_columns});
}

}  // namespace lober::bench
