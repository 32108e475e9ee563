// The picture of fluxes over n, of `lober transport`.

#include <array>
#include <cmath>

#include "cli/picture/system_figure.hpp"
#include "cli/transport/transport_report.hpp"

namespace lober::cli {
Figure fluxes_figure(const TransportReport& report, bool normalised) {
  Figure figure{.what = "Fluxes over n", .title = system_title(report.system.info)};
  figure.plane = false;
  figure.zero_line = true;
  figure.x = {"n", "", true};
  const std::vector<TransportStep>& steps = report.result().steps;
  const double first = steps.empty() ? 0 : steps.front().flux(0, 1).value;
  normalised = normalised && first > 0;
  const double unit = normalised ? first : 1;
  figure.y = {normalised ? "area / a(1)" : "area"};
  const auto layer = [](const char* name, const char* legend, const char* colour, DotShape shape) {
    Layer made = dot_layer(name, legend, {}, 1.7);
    made.colour = colour;
    made.shape = shape;
    return made;
  };
  Layer flux = layer("a12(n)", "a(n), area that crosses in step n", palette::flux, DotShape::circle);
  Layer total = layer("T12(n)", "T(n), in all, by lobes", palette::total, DotShape::circle);
  Layer boundaries = layer("T12(n) by boundaries", "T(n) by boundaries", palette::total, DotShape::square);
  Layer particles = layer("T12(n) by particles", "T(n) by particles", palette::estimate, DotShape::triangle);
  boundaries.hollow = true;
  boundaries.radius = 2.6;
  particles.hollow = true;
  Rectangle box;
  const auto add = [&](Layer& to, int n, Measured measured) {
    if (!std::isfinite(measured.value)) return;
    measured = 1 / unit * measured;
    const Point at{static_cast<double>(n), measured.value};
    to.points.push_back(at);
    to.errors.push_back(measured.error);
    const double error = std::isfinite(measured.error) ? measured.error : 0;
    box = include(box, std::array{Point{at.x, 0}, Point{at.x, at.y - error}, Point{at.x, at.y + error}});
  };
  for (const TransportStep& step : steps) {
    add(flux, step.n, step.flux(0, 1));
    add(total, step.n, step.total(0, 1));
    if (step.by_boundaries.size() > 1) add(boundaries, step.n, step.by_boundaries(0, 1));
    if (step.by_particles.size() > 1) add(particles, step.n, step.by_particles(0, 1));
  }
  for (const Layer* dots : {&flux, &total}) {
    Layer line = line_layer(dots->name, "", dots->colour, 0.6);
    line.lines.push_back(polyline(dots->points, false));
    figure.layers.push_back(std::move(line));
  }
  for (Layer* dots : {&boundaries, &flux, &total, &particles}) {
    if (!dots->points.empty()) figure.layers.push_back(std::move(*dots));
  }
  figure.notes.push_back("bars: errors; most are smaller than the dots");
  if (!box.empty()) figure.window = widened_plot(box);
  return figure;
}

Rectangle widened_plot(const Rectangle& box) {
  Rectangle window = box;
  const double x = box.width() > 0 ? 0.04 * box.width() : 0.5, y = box.height() > 0 ? 0.05 * box.height() : 0.5;
  window.min_x -= x;
  window.max_x += x;
  if (box.min_y < 0) window.min_y -= y;
  window.max_y += y;
  return window;
}

}  // namespace lober::cli
