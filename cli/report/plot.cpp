#include "cli/report/plot.hpp"

#include <algorithm>
#include <cmath>

#include "cli/report/svg.hpp"
#include "cli/report/text.hpp"
#include "lober/curve/curve.hpp"
#include "lober/curve/files.hpp"

namespace lober::cli {
namespace {

constexpr std::size_t max_plot_points = 5'000;

bool drawable(Point point) {
  return std::isfinite(point.x) && std::isfinite(point.y);
}

// 1, 2 or 5 times a power of ten, so that there are at most `max_steps` steps.
double tick_step(double range, int max_steps) {
  const double power = std::pow(10, std::floor(std::log10(range / max_steps)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (range / (factor * power) <= max_steps) return factor * power;
  }
  return 10 * power;
}

// Data to the plot, which is twice as wide as high whatever the scales.
class Axes {
 public:
  explicit Axes(const Plot& plot) : view_(Rectangle::of({0, 0}, {2, 1})) {
    Rectangle box;
    for (const PlotSeries& series : plot.series) {
      for (const Point point : series.points) {
        if (drawable(point)) {
          box.add({point.x, 0});
          box.add(point);
        }
      }
    }
    if (box.empty()) box = Rectangle::of({0, 0}, {1, 1});
    const auto widened = [](double low, double high, double& begin, double& end) {
      const double margin = high > low ? 0.05 * (high - low) : 0.5;
      begin = low - margin;
      end = high + margin;
    };
    widened(box.min_x, box.max_x, low_.x, high_.x);
    widened(box.min_y, box.max_y, low_.y, high_.y);
  }
  [[nodiscard]] const View& view() const { return view_; }
  [[nodiscard]] Point low() const { return low_; }
  [[nodiscard]] Point high() const { return high_; }
  [[nodiscard]] Point in_plot(Point point) const {
    return {2 * (point.x - low_.x) / (high_.x - low_.x), (point.y - low_.y) / (high_.y - low_.y)};
  }
  [[nodiscard]] Pixel pixel(Point point) const { return view_(in_plot(point)); }
  [[nodiscard]] std::string path(std::span<const Point> line) const {
    std::vector<Point> moved;
    for (const Point point : line) moved.push_back(in_plot(point));
    return path_of(view_, max_plot_points, [&](PathWriter& writer) { writer.add_line(moved); });
  }

 private:
  View view_;
  Point low_, high_;
};

struct Tick {
  double value;
  std::string label;
};
std::vector<Tick> ticks(double low, double high, int most) {
  const double step = tick_step(high - low, most);
  std::vector<Tick> list;
  for (double k = std::ceil(low / step); k * step <= high; ++k) {
    list.push_back({k * step, rounded(std::round(k * step * 1e12) / 1e12 + 0.0)});
  }
  return list;
}

void add_line(std::string& svg, const Axes& axes, Point a, Point b, const char* colour, double pixels) {
  const std::vector<Point> line{a, b};
  add_stroked(svg, colour, pixels, axes.path(line));
}

void add_series(std::string& svg, const Axes& axes, const PlotSeries& series) {
  std::vector<Point> part;
  const auto finish = [&] {
    if (series.line && part.size() > 1) add_stroked(svg, series.colour, 2, axes.path(part));
    part.clear();
  };
  for (const Point point : series.points) drawable(point) ? part.push_back(point) : finish();
  finish();
  if (!series.dots) return;
  append_all(svg, "<g fill=\"", series.colour, "\">\n");
  for (const Point point : series.points) {
    if (drawable(point)) add_dot(svg, axes.pixel(point), 4);
  }
  svg += "</g>\n";
}

void add_label(std::string& svg, Pixel at, const char* anchor, std::string_view text) {
  append_all(svg, "<text x=\"", std::round(at.x), "\" y=\"", std::round(at.y), "\" text-anchor=\"", anchor,
             "\" font-family=\"sans-serif\" font-size=\"13\" fill=\"#555555\">", text, "</text>\n");
}

}  // namespace

void write_plot(const std::string& path, const Plot& plot) {
  const Axes axes(plot);
  const std::vector<Tick> across = ticks(axes.low().x, axes.high().x, 12), up = ticks(axes.low().y, axes.high().y, 8);
  constexpr const char* grid_colour = "#dddad2";
  constexpr const char* axis_colour = "#8a877f";
  std::string svg;
  const int legend_lines = 1 + static_cast<int>((plot.series.size() + 1) / 2);
  begin_picture(svg, axes.view(), plot.title, legend_lines);
  for (const Tick& tick : across)
    add_line(svg, axes, {tick.value, axes.low().y}, {tick.value, axes.high().y}, grid_colour, 1);
  for (const Tick& tick : up)
    add_line(svg, axes, {axes.low().x, tick.value}, {axes.high().x, tick.value}, grid_colour, 1);
  add_line(svg, axes, {axes.low().x, 0}, {axes.high().x, 0}, axis_colour, 1.5);
  for (const double mark : plot.marks) add_line(svg, axes, {mark, axes.low().y}, {mark, axes.high().y}, "#b3261e", 1);
  for (const PlotSeries& series : plot.series) add_series(svg, axes, series);
  begin_legend(svg);
  for (const Tick& tick : across) {
    const Pixel at = axes.pixel({tick.value, axes.low().y});
    add_label(svg, {at.x, at.y + 16}, "middle", tick.label);
  }
  for (const Tick& tick : up) {
    const Pixel at = axes.pixel({axes.low().x, tick.value});
    add_label(svg, {at.x + 4, at.y - 4}, "start", tick.label);
  }
  add_legend_entry(svg, axes.view(), 0, 0, "", plot.x_label);
  for (std::size_t k = 0; k < plot.series.size(); ++k) {
    const PlotSeries& series = plot.series[k];
    std::string swatch;
    if (series.line) swatch += line_swatch(series.colour, 2);
    if (series.dots) append_all(swatch, "<circle cx=\"13\" r=\"4\" fill=\"", series.colour, "\"/>");
    add_legend_entry(svg, axes.view(), static_cast<int>(k % 2), 1 + static_cast<int>(k / 2), swatch, series.label);
  }
  end_picture(svg);
  write_file(path, svg);
}

}  // namespace lober::cli
