// Curves over an axis, as SVG.
#pragma once

#include <string>
#include <vector>

#include "lober/curve/point.hpp"

namespace lober::cli {

struct PlotSeries {
  std::string label, colour;
  std::vector<Point> points;  ///< ascending in x; one that is not finite parts the line
  bool line = true, dots = false;
};

struct Plot {
  std::string title, x_label;
  std::vector<PlotSeries> series;
  std::vector<double> marks;  ///< positions on the x axis with a vertical line
};

/// The window fits the points and y = 0. Throws DataError when the file cannot be written.
void write_plot(const std::string& path, const Plot& plot);

}  // namespace lober::cli
