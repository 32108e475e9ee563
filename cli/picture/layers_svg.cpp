#include "cli/picture/layers_svg.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "cli/picture/labels.hpp"
#include "cli/picture/legend.hpp"
#include "cli/picture/path_writer.hpp"
#include "cli/picture/rich_text.hpp"
#include "cli/report/text.hpp"

namespace lober::cli {
namespace {

constexpr std::size_t max_path_points = 60'000;  // points of a path: a picture stays below a megabyte or so
constexpr double arrow_length = 4.5;

// Base, apex and base of a head.
std::array<PrintPoint, 3> arrow_outline(PrintPoint from, PrintPoint apex) {
  const double distance = std::hypot(apex.x - from.x, apex.y - from.y);
  if (!(distance > 0)) return {apex, apex, apex};
  const double x = (apex.x - from.x) / distance * arrow_length, y = (apex.y - from.y) / distance * arrow_length;
  return {PrintPoint{apex.x - x - 0.4 * y, apex.y - y + 0.4 * x}, apex,
          PrintPoint{apex.x - x + 0.4 * y, apex.y - y - 0.4 * x}};
}

void add_arrow_head(std::string& svg, PrintPoint from, PrintPoint apex, std::string_view colour) {
  const auto [first, apex_point, second] = arrow_outline(from, apex);
  if (first == apex_point) return;
  append_all(svg, "<path fill=\"", colour, "\" d=\"M", path_unit(apex_point.x), " ", path_unit(apex_point.y), "L",
             path_unit(first.x), " ", path_unit(first.y), " ", path_unit(second.x), " ", path_unit(second.y),
             "z\"/>\n");
}

// Heads along a line, the first one half a spacing from its beginning, or one at its end.
void add_arrows(std::string& svg, const Layer& layer, const View& view, const Polyline& line) {
  const std::string& colour = line.colour.empty() ? layer.colour : line.colour;
  double left = 0.5 * layer.arrows;
  for (const auto& part : clipped_line(view, line.points(), line.closed, 0)) {
    if (layer.arrow_at_end) {
      add_arrow_head(svg, part[part.size() - 2], part.back(), colour);
      continue;
    }
    for (std::size_t k = 0; k + 1 < part.size(); ++k) {
      const PrintPoint a = part[k], b = part[k + 1];
      const double length = std::hypot(b.x - a.x, b.y - a.y);
      double done = 0;
      while (length > 0 && done + left <= length) {
        done += left;
        left = layer.arrows;
        const PrintPoint apex{a.x + done / length * (b.x - a.x), a.y + done / length * (b.y - a.y)};
        add_arrow_head(svg, a, apex, colour);
      }
      left -= length - done;
    }
  }
}

// Lines of one colour are one path.
void add_lines(std::string& svg, const Layer& layer, const View& view) {
  for (std::size_t first = 0; first < layer.lines.size();) {
    std::size_t end = first + 1;
    while (end < layer.lines.size() && layer.lines[end].colour == layer.lines[first].colour) ++end;
    const std::string path = path_of(view, max_path_points, [&](PathWriter& writer) {
      for (std::size_t k = first; k < end; ++k) writer.add_line(layer.lines[k].points(), layer.lines[k].closed);
    });
    const std::string& own = layer.lines[first].colour;
    if (!path.empty()) {
      append_all(svg, "<path fill=\"none\" stroke=\"", own.empty() ? layer.colour : own, "\" stroke-width=\"",
                 std::round(layer.width * path_units), "\"");
      if (layer.dashed) append_all(svg, " stroke-dasharray=\"", 3 * path_units, " ", 2 * path_units, "\"");
      append_all(svg, " d=\"", path, "\"/>\n");
    }
    first = end;
  }
  if (layer.arrows > 0 || layer.arrow_at_end) {
    for (const Polyline& line : layer.lines) add_arrows(svg, layer, view, line);
  }
}

void add_fills(std::string& svg, const Layer& layer, const View& view) {
  for (std::size_t first = 0; first < layer.lines.size();) {
    std::size_t end = first + 1;
    while (end < layer.lines.size() && layer.lines[end].colour == layer.lines[first].colour) ++end;
    const std::string path = path_of(view, max_path_points, [&](PathWriter& writer) {
      for (std::size_t k = first; k < end && !writer.full(); ++k) writer.add_polygon(layer.lines[k].points());
    });
    const std::string& own = layer.lines[first].colour;
    if (!path.empty()) {
      append_all(svg, "<path fill=\"", own.empty() ? layer.colour : own, "\" fill-opacity=\"", layer.opacity,
                 "\" fill-rule=\"", layer.even_odd ? "evenodd" : "nonzero", "\" d=\"", path, "\"/>\n");
    }
    first = end;
  }
}

void add_boxes(std::string& svg, const Layer& layer, const View& view) {
  std::string path;
  const Frame& frame = view.frame();
  for (const Rectangle& box : layer.boxes) {
    const PrintPoint a = view({box.min_x, box.max_y}), b = view({box.max_x, box.min_y});
    if (b.x < frame.x || a.x > frame.right() || b.y < frame.y || a.y > frame.bottom()) continue;
    const int x = path_unit(std::max(a.x, frame.x)), y = path_unit(std::max(a.y, frame.y));
    const int width = path_unit(std::min(b.x, frame.right())) - x,
              height = path_unit(std::min(b.y, frame.bottom())) - y;
    append_all(path, "M", x, " ", y, "h", width, "v", height, "h", -width, "z");
  }
  if (path.empty()) return;
  append_all(svg, "<path shape-rendering=\"crispEdges\" fill=\"", layer.colour, "\" d=\"", path, "\"/>\n");
}

void add_error_bars(std::string& svg, const Layer& layer, const View& view) {
  constexpr double cap = 1.4;
  std::string path;
  for (std::size_t k = 0; k < layer.errors.size(); ++k) {
    const Point at = layer.points[k];
    const double error = layer.errors[k];
    if (!(std::isfinite(error) && std::isfinite(at.y) && view.contains({at.x, view.window().min_y}))) continue;
    const auto height = [&](double y) { return view({at.x, std::clamp(y, view.window().min_y, view.window().max_y)}); };
    const PrintPoint low = height(at.y - error), high = height(at.y + error);
    append_all(path, "M", path_unit(low.x - cap), " ", path_unit(low.y), "h", path_unit(2 * cap), "M",
               path_unit(high.x - cap), " ", path_unit(high.y), "h", path_unit(2 * cap), "M", path_unit(low.x), " ",
               path_unit(low.y), "V", path_unit(high.y));
  }
  if (path.empty()) return;
  append_all(svg, "<path fill=\"none\" stroke=\"", layer.colour, "\" stroke-width=\"", path_units / 2, "\" d=\"", path,
             "\"/>\n");
}

// Dots that others of the layer would hide are left out.
void add_dots(std::string& svg, const Layer& layer, const View& view) {
  const Frame& frame = view.frame();
  Coverage coverage(frame.width, frame.height, std::max(0.1, 0.3 * layer.radius));
  for (const Point& point : layer.points) {
    if (!view.contains(point)) continue;
    const PrintPoint at = view(point), inside{at.x - frame.x, at.y - frame.y};
    if (!coverage.mark(inside, inside)) continue;
    add_dot(svg, layer, at.x * path_units, at.y * path_units, path_units);
  }
}

std::vector<PrintPoint> small_polygon(const View& view, std::span<const Point> polygon) {
  return simplified_line(clipped_polygon(view, polygon, 20), 0.5);
}

}  // namespace

void add_layers(std::string& svg, const Figure& figure, const View& view, const char* name) {
  const Frame& frame = view.frame();
  append_all(svg, "<clipPath id=\"", name, "\"><rect x=\"", hundredth(frame.x), "\" y=\"", hundredth(frame.y),
             "\" width=\"", hundredth(frame.width), "\" height=\"", hundredth(frame.height),
             "\"/></clipPath>\n<g clip-path=\"url(#", name, ")\"><g transform=\"scale(", 1.0 / path_units,
             ")\" stroke-linejoin=\"round\">\n");
  for (const Layer& layer : figure.layers) {
    switch (layer.kind) {
      case LayerKind::fill:
        add_fills(svg, layer, view);
        break;
      case LayerKind::line:
        add_lines(svg, layer, view);
        break;
      case LayerKind::dots:
        add_error_bars(svg, layer, view);
        add_dots(svg, layer, view);
        break;
      case LayerKind::boxes:
        add_boxes(svg, layer, view);
    }
  }
  svg += "</g></g>\n";
}

void add_labels(std::string& svg, const Figure& figure, const View& view, const Frame* taken, double scale) {
  if (figure.labels.empty()) return;
  Labels labels(view);
  if (taken != nullptr) labels.avoid_frame(*taken);
  for (const Layer& layer : figure.layers) {
    if (layer.kind == LayerKind::line && layer.width < 1.5) {  // bands may be written on
      for (const Polyline& line : layer.lines) {
        for (const auto& part : clipped_line(view, line.points(), line.closed, 0)) {
          labels.avoid_line(part);
          if (layer.arrow_at_end) labels.avoid_line(arrow_outline(part[part.size() - 2], part.back()));
        }
      }
    }
    if (layer.kind != LayerKind::dots || layer.points.size() > 300) continue;
    for (const Point& point : layer.points) {
      if (view.contains(point)) labels.avoid_dot(view(point), layer.radius);
    }
  }
  for (const FigureLabel& label : figure.labels) {
    const double size = std::max(min_text_size, scale * label.size);
    switch (label.position) {
      case FigureLabel::Position::beside:
        if (view.contains(label.at) && !(taken != nullptr && taken->holds(view(label.at))))
          labels.add_beside(view(label.at), label.radius, label.text, size);
        break;
      case FigureLabel::Position::inside:
        labels.add_inside(small_polygon(view, label.polygon.points()), label.text, size);
        break;
      case FigureLabel::Position::outside:
        labels.add_outside(small_polygon(view, label.polygon.points()), label.text, size);
    }
  }
  svg += labels.drawn();
}

}  // namespace lober::cli
