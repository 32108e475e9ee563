// The picture of level curves.

#include <algorithm>
#include <array>
#include <cmath>

#include "cli/levels/levels_report.hpp"
#include "cli/picture/cells.hpp"
#include "cli/picture/system_figure.hpp"

namespace lober::cli {
namespace {

// From low to high, blue to sand.
constexpr std::array<const char*, 7> band_colours{"#5d86b0", "#7f9fc2", "#a0b8d3", "#bfcfe1",
                                                  "#d9e1eb", "#e9e6df", "#e3d9c9"};
constexpr const char* forbidden_colour = "#c9c6be";
constexpr const char* line_colour = "#44505e";

// The cells whose mean value lies in a band.
template <typename InBand>
Layer band_layer(const LevelGrid& grid, std::string name, std::string legend, const char* colour,
                 const InBand& in_band) {
  Layer layer = box_layer(std::move(name), std::move(legend), colour);
  layer.boxes = cell_boxes(
      grid.columns(), grid.rows(),
      [&](std::size_t column, std::size_t row) {
        return in_band(0.25 * (grid.value(column, row) + grid.value(column + 1, row) + grid.value(column, row + 1) +
                               grid.value(column + 1, row + 1)));
      },
      [&](std::size_t column, std::size_t row) { return grid.node(column, row); });
  return layer;
}

void add_bands(Figure& figure, const LevelsReport& report) {
  const std::vector<operations::SystemLevel>& levels = report.result().levels;
  const LevelGrid& grid = *report.result().grid;
  if (report.energy) {
    const double energy = *report.energy;
    // Without a value, as at a mass, the potential has no lower bound: motion is possible there.
    figure.layers.push_back(band_layer(grid, "no motion", "potential above " + rounded(energy) + ": no motion",
                                       forbidden_colour, [&](double value) { return value > energy; }));
    return;
  }
  for (std::size_t k = 0; k <= levels.size() && report.shaded; ++k) {
    const double low = k == 0 ? -HUGE_VAL : levels[k - 1].value;
    const double high = k == levels.size() ? HUGE_VAL : levels[k].value;
    const std::string text = k == 0               ? "below " + rounded(high)
                             : k == levels.size() ? rounded(low) + " and above"
                                                  : rounded(low) + " to " + rounded(high);
    const std::string name = std::string(report.quantity()) + " " + text;
    figure.layers.push_back(band_layer(grid, name, name, band_colours[k * (band_colours.size() - 1) / levels.size()],
                                       [&](double value) { return value >= low && value < high; }));
  }
}

}  // namespace

Figure levels_figure(const LevelsReport& report) {
  const std::vector<operations::SystemLevel>& levels = report.result().levels;
  const Rectangle& window = report.result().grid->window();
  Figure figure{.what = "Level curves of " + report.system.info.name};
  // The energy of a return map is not that of the picture.
  SystemInfo named = report.system.info;
  std::erase_if(named.parameters, [](const Parameter& parameter) { return parameter.name == "energy"; });
  if (report.energy) {
    named.parameters.emplace_back();
    named.parameters.back().name = "energy";
    named.parameters.back().value = *report.energy;
  }
  figure.title = system_title(named);
  figure.window = window;
  add_bands(figure, report);
  // Lines through saddles on top of the others.
  for (const bool through : {false, true}) {
    for (const operations::SystemLevel& level : levels) {
      if (level.saddle.has_value() != through || level.curves.empty()) continue;
      const bool zero_velocity = report.energy && level.value == *report.energy;
      const std::string value = std::string(report.quantity()) + " = " + rounded(level.value);
      const bool plane = report.system.flow->dimension() == 2;
      Layer layer =
          line_layer(value,
                     zero_velocity ? "zero-velocity curve"
                     : through     ? "through a saddle, " + value
                     : plane       ? "streamlines, levels of H"
                                   : "levels of the potential",
                     through && !zero_velocity ? palette::unstable : line_colour, through || zero_velocity ? 0.9 : 0.4);
      for (const LevelCurve& curve : level.curves) {
        layer.lines.push_back(polyline(std::span<const Point>(curve.points), curve.closed, value));
      }
      figure.layers.push_back(std::move(layer));
    }
  }
  if (!report.orbits.empty()) {
    const bool one = report.orbits.size() == 1;
    Layer orbits = line_layer("periodic orbits", one ? "periodic orbit" : "periodic orbits", palette::common, 1.2);
    for (const std::vector<Point>& orbit : report.orbits) {
      orbits.lines.push_back(polyline(std::span<const Point>(orbit), true));
    }
    figure.layers.push_back(std::move(orbits));
  }
  Layer saddles = dot_layer("saddles", "saddles", {}, 1.8);
  saddles.shape = DotShape::square;
  for (const Equilibrium& saddle : report.result().saddles) {
    const Point at{saddle.at.x, saddle.at.y};
    if (window.contains(at)) saddles.points.push_back(at);
  }
  if (!saddles.points.empty()) figure.layers.push_back(std::move(saddles));
  return figure;
}

}  // namespace lober::cli
