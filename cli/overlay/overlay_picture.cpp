// The picture of an overlay: two curves, and the lobes between them in two colours.

#include <algorithm>
#include <cmath>

#include "cli/overlay/overlay_report.hpp"
#include "cli/report/labels.hpp"
#include "cli/report/svg.hpp"

namespace lober::cli {
namespace {

constexpr std::size_t max_overlay_dots = 500;

constexpr const char* colour1 = "#1f5fa8";
constexpr const char* colour2 = "#c8501e";

std::string pieces_path(const View& view, const Overlay& result, Pairing pairing) {
  return path_of(view, max_path_points, [&](PathWriter& writer) {
    for (std::size_t k = 0; k < result.pieces(pairing).size(); ++k) {
      for (const std::vector<Point>& polygon : outline(result, pairing, k)) writer.add_polygon(polygon);
    }
  });
}

void add_dots(std::string& svg, const View& view, const Crossings& nodes) {
  if (nodes.crossings() >= max_overlay_dots) return;
  svg += "<g fill=\"#222222\" stroke=\"#ffffff\" stroke-width=\"" + std::to_string(subpixels) + "\">\n";
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const Node node = nodes[k];
    if (node.rho != 0) add_dot(svg, view(node.begin), 3);
  }
  svg += "</g>\n";
}

void add_legend(std::string& svg, const View& view, const CurveOverlay& found) {
  const auto pieces = [&](Pairing pairing) {
    const std::size_t count = found.pieces(pairing).size();
    return std::to_string(count) + (count == 1 ? " lobe, area " : " lobes, area ");
  };
  const Areas& areas = found.areas;
  add_legend_entry(svg, view, 0, 0, line_swatch(colour1, 2), "C1, area " + rounded(areas.c1));
  add_legend_entry(svg, view, 1, 0, filled_swatch(colour1),
                   "C1 \\ C2: " + pieces(Pairing::c1_minus_c2) + rounded(areas.c1_minus_c2));
  add_legend_entry(svg, view, 0, 1, line_swatch(colour2, 2), "C2, area " + rounded(areas.c2));
  add_legend_entry(svg, view, 1, 1, filled_swatch(colour2),
                   "C2 \\ C1: " + pieces(Pairing::c2_minus_c1) + rounded(areas.c2_minus_c1));
}

// ---------------------------------------------------------------------------------- with classes

constexpr const char* leaves_colour = "#2e7d32";  // rho = +1: C1 leaves A2
constexpr const char* enters_colour = "#1f5fa8";  // rho = -1: C1 enters A2
constexpr std::size_t max_numbered = 60;          // crossings
constexpr std::array<const char*, 6> class_colours{"#8a5fb0", "#3f8f6b", "#c8701e", "#1f5fa8", "#b3261e", "#7a7a2e"};

// Unit vector along the curve, counter-clockwise, at a position of it.
Point tangent(const CurveView& curve, bool clockwise, const Position& at) {
  const std::size_t n = curve.points.size();
  const Point a = curve.points[at.segment], b = curve.points[(at.segment + 1) % n];
  const double length = std::hypot(b.x - a.x, b.y - a.y), sign = clockwise ? -1 : 1;
  return length > 0 ? Point{sign * (b.x - a.x) / length, sign * (b.y - a.y) / length} : Point{};
}

// Draws the tangents at every crossing along both curves, as rho is defined.
void add_tangents(std::string& svg, const View& view, const Crossings& nodes, Labels& labels) {
  constexpr double length = 34;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const Node node = nodes[k];
    if (node.rho == 0) continue;
    const Pixel from = view(node.begin);
    const auto add = [&](Point along, const char* colour) {
      const Pixel apex{from.x + length * along.x, from.y - length * along.y};
      std::string path;
      path = "M" + std::to_string(subpixel(from.x)) + " " + std::to_string(subpixel(from.y)) + "L" +
             std::to_string(subpixel(apex.x - 8 * along.x)) + " " + std::to_string(subpixel(apex.y + 8 * along.y));
      add_stroked(svg, colour, 4, path);
      add_arrow_head(svg, from, apex, 13, colour);
      labels.avoid(apex, 9);
    };
    add(tangent(nodes.curve1(), nodes.clockwise1(), node.begin1), colour1);
    add(tangent(nodes.curve2(), nodes.clockwise2(), node.begin2), colour2);
  }
}

// Halfway from p to sigma(p) along the boundary of the piece, an arrow in the direction of sigma: black where it
// follows C1 (rho(p) = +1), red where it follows C2.
void add_sigma_arrows(std::string& svg, const View& view, const Crossings& nodes, const std::vector<Point>& loop) {
  std::vector<std::pair<std::size_t, int>> corners;  // vertices of the loop that are crossings, and rho there
  for (std::size_t vertex = 0; vertex < loop.size(); ++vertex) {
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const Node node = nodes[k];
      if (node.rho != 0 && (node.begin == loop[vertex] || node.end == loop[vertex])) {
        corners.emplace_back(vertex, node.rho);
        break;
      }
    }
  }
  const auto pixel = [&](std::size_t vertex) { return view(loop[vertex % loop.size()]); };
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const std::size_t first = corners[k].first;
    std::size_t last = corners[(k + 1) % corners.size()].first;
    if (last <= first) last += loop.size();
    double length = 0;
    const auto step = [&](std::size_t vertex) {
      const Pixel a = pixel(vertex), b = pixel(vertex + 1);
      return std::hypot(b.x - a.x, b.y - a.y);
    };
    for (std::size_t vertex = first; vertex < last; ++vertex) length += step(vertex);
    double left = 0.5 * length;
    for (std::size_t vertex = first; vertex < last; ++vertex) {
      const double here = step(vertex);
      if (left > here || !(here > 0)) {
        left -= here;
        continue;
      }
      const Pixel a = pixel(vertex), b = pixel(vertex + 1);
      const Pixel apex{a.x + (left + 9) / here * (b.x - a.x), a.y + (left + 9) / here * (b.y - a.y)};
      add_arrow_head(svg, a, apex, 18, corners[k].second > 0 ? "#222222" : "#b3261e");
      break;
    }
  }
}

void add_numbered_dots(std::string& svg, const View& view, const Crossings& nodes) {
  for (const int rho : {1, -1}) {
    svg += std::string("<g fill=\"") + (rho > 0 ? leaves_colour : enters_colour) +
           "\" stroke=\"#ffffff\" stroke-width=\"" + std::to_string(subpixels) + "\">\n";
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const Node node = nodes[k];
      if (node.rho == rho) add_dot(svg, view(node.begin), 6);
    }
    svg += "</g>\n";
  }
}

std::vector<Point> closed(const CurveView& curve) {
  std::vector<Point> line(curve.points.begin(), curve.points.end());
  line.push_back(line.front());
  return line;
}

void draw_classes(std::string& svg, const View& view, const CurveOverlay& found, bool clipped) {
  const Overlay& result = found;
  const Crossings& nodes = result.nodes;
  const std::vector<SigmaStep>& steps = (*found.steps)[0];
  const std::size_t classes = class_count(steps), entries = std::min(classes, class_colours.size());
  begin_picture(svg, view, "Crossings of two curves and their classes", static_cast<int>(4 + (entries + 1) / 2),
                clipped);
  Labels labels(view);
  for (const CurveView& curve : {nodes.curve1(), nodes.curve2()}) labels.avoid(closed(curve));
  // The class of a loop is that of the first crossing on it.
  std::vector<std::vector<std::vector<Point>>> loops(std::max<std::size_t>(classes, 1));
  for (std::size_t piece = 0; piece < result.pieces(Pairing::c1_minus_c2).size(); ++piece) {
    for (std::vector<Point>& loop : outline(result, Pairing::c1_minus_c2, piece)) {
      std::size_t number = 0;
      for (const SigmaStep& step : steps) {
        const Point at = nodes[step.crossing].begin;
        if (std::find(loop.begin(), loop.end(), at) != loop.end()) number = step.class_number;
      }
      loops[number].push_back(std::move(loop));
    }
  }
  for (std::size_t k = 0; k < loops.size(); ++k) {
    add_filled(svg, class_colours[k % class_colours.size()], "evenodd",
               path_of(view, max_path_points, [&](PathWriter& writer) {
                 for (const std::vector<Point>& loop : loops[k]) writer.add_polygon(loop);
               }));
  }
  add_stroked(svg, colour1, 2.4, polygon_path(view, nodes.curve1().points, max_path_points));
  add_stroked(svg, colour2, 1.6, polygon_path(view, nodes.curve2().points, max_path_points));
  if (nodes.crossings() <= max_numbered) {
    for (const auto& list : loops) {
      for (const std::vector<Point>& loop : list) add_sigma_arrows(svg, view, nodes, loop);
    }
    add_tangents(svg, view, nodes, labels);
  }
  add_numbered_dots(svg, view, nodes);
  begin_legend(svg);
  if (nodes.crossings() <= max_numbered) {
    for (const SigmaStep& step : steps) labels.avoid(view(nodes[step.crossing].begin), 6);
    for (const SigmaStep& step : steps) {
      const Pixel at = view(nodes[step.crossing].begin);
      labels.add_beside(at, 8, "p_{" + std::to_string(step.crossing) + "}", 19);
    }
    svg += labels.drawn();
  }
  const auto dot = [](const char* colour) {
    return std::string("<circle cx=\"13\" r=\"6\" fill=\"") + colour + "\"/>";
  };
  const auto arrow = [](const char* colour) {
    return std::string("<path d=\"M22 0L4 -7L4 7z\" fill=\"") + colour + "\"/>";
  };
  const Areas& areas = result.areas;
  add_legend_entry(svg, view, 0, 0, line_swatch(colour1, 2.4), "C1 and its tangent, area " + rounded(areas.c1));
  add_legend_entry(svg, view, 1, 0, line_swatch(colour2, 1.6), "C2 and its tangent, area " + rounded(areas.c2));
  add_legend_entry(svg, view, 0, 1, dot(leaves_colour), "rho = +1, C1 leaves A2");
  add_legend_entry(svg, view, 1, 1, dot(enters_colour), "rho = \u22121, C1 enters A2");
  add_legend_entry(svg, view, 0, 2, arrow("#222222"), "sigma along C1, forward");
  add_legend_entry(svg, view, 1, 2, arrow("#b3261e"), "sigma along C2, backward");
  for (std::size_t k = 0; k < entries; ++k) {
    double sum = 0;
    std::string members;
    std::size_t count = 0;
    for (const SigmaStep& step : steps) {
      if (step.class_number != k) continue;
      sum += step.s;
      if (++count <= 8) members += (members.empty() ? "" : ", ") + std::string("p") + std::to_string(step.crossing);
    }
    if (count > 8) members += ", ...";
    add_legend_entry(svg, view, static_cast<int>(k % 2), static_cast<int>(3 + k / 2), filled_swatch(class_colours[k]),
                     "class " + std::to_string(k) + " {" + members + "}, half the sum of S " + rounded(sum / 2));
  }
  if (classes > entries) {
    add_legend_entry(svg, view, 0, static_cast<int>(3 + (entries + 1) / 2), "",
                     std::to_string(classes) + " classes in all; colours repeat");
  }
  end_picture(svg);
}

}  // namespace

void write_picture(const std::string& path, const CurveOverlay& found, const std::optional<Rectangle>& window) {
  const Overlay& result = found;
  const CurveView &c1 = result.nodes.curve1(), &c2 = result.nodes.curve2();
  const View view(window ? *window : include(include({}, c1.points), c2.points));
  std::string svg;
  if (found.steps) {
    draw_classes(svg, view, found, window.has_value());
    write_file(path, svg);
    return;
  }
  begin_picture(svg, view, "Lobes between two curves", 2, window.has_value());
  add_filled(svg, colour1, "evenodd", pieces_path(view, result, Pairing::c1_minus_c2));
  add_filled(svg, colour2, "evenodd", pieces_path(view, result, Pairing::c2_minus_c1));
  // The first curve is the wider one, so that it can be seen where they share an arc.
  add_stroked(svg, colour1, 2.4, polygon_path(view, c1.points, max_path_points));
  add_stroked(svg, colour2, 1.2, polygon_path(view, c2.points, max_path_points));
  add_dots(svg, view, result.nodes);
  begin_legend(svg);
  add_legend(svg, view, found);
  end_picture(svg);
  write_file(path, svg);
}

}  // namespace lober::cli
