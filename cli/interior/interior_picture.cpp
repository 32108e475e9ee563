// The picture of the paths of Q1, Q2 and Q3: the parts of two curves outside and inside of each other.

#include <algorithm>
#include <array>
#include <cmath>

#include "cli/interior/interior_report.hpp"
#include "cli/report/svg.hpp"
#include "cli/report/text.hpp"
#include "lober/curve/files.hpp"

namespace lober::cli {
namespace {

constexpr double arrow_spacing = 140;  // pixels along a curve
constexpr std::array<const char*, 2> curve_colours{"#1f5fa8", "#c8501e"};
constexpr const char* on_colour = "#222222";

struct Part {
  Side side;
  std::vector<Point> line;
};

// A curve, counter-clockwise, cut where it passes to another side of the other one.
std::vector<Part> side_parts(const Crossings& nodes, int curve) {
  const IndexedCurve other(curve == 1 ? nodes.curve2() : nodes.curve1());
  std::vector<LabelledPoint> points = labelled_points(nodes, curve);
  if (curve == 1 ? nodes.clockwise1() : nodes.clockwise2()) std::reverse(points.begin(), points.end());
  std::vector<Part> parts;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const LabelledPoint &a = points[k], &b = points[k + 1 < points.size() ? k + 1 : 0];
    // Both ends on the other curve: a segment with nothing between two contacts, or shared.
    const Side side = a.side != Side::on ? a.side
                      : b.side != Side::on
                          ? b.side
                          : locate(other, {0.5 * (a.point.x + b.point.x), 0.5 * (a.point.y + b.point.y)});
    if (parts.empty() || parts.back().side != side) parts.push_back({side, {a.point}});
    parts.back().line.push_back(b.point);
  }
  return parts;
}

std::string side_path(const View& view, const std::vector<Part>& parts, Side side) {
  return path_of(view, max_path_points, [&](PathWriter& writer) {
    for (const Part& part : parts) {
      if (part.side == side) writer.add_line(part.line);
    }
  });
}

// In the direction in which the integrals run.
void add_arrows(std::string& svg, const View& view, const std::vector<Part>& parts, const char* colour) {
  double left = 0.5 * arrow_spacing;
  for (const Part& part : parts) {
    for (std::size_t k = 0; k + 1 < part.line.size(); ++k) {
      const Pixel a = view(part.line[k]), b = view(part.line[k + 1]);
      const double length = std::hypot(b.x - a.x, b.y - a.y);
      double done = 0;
      while (length > 0 && done + left <= length) {
        done += left;
        left = arrow_spacing;
        const Pixel apex{a.x + done / length * (b.x - a.x), a.y + done / length * (b.y - a.y)};
        add_arrow_head(svg, a, apex, 14, colour);
      }
      left -= length - done;
    }
  }
}

std::string dashed_swatch(const char* colour) {
  std::string swatch;
  append_all(swatch, "<path d=\"M0 0h26\" stroke=\"", colour, "\" stroke-width=\"2\" stroke-dasharray=\"6 4\"/>");
  return swatch;
}

}  // namespace

void write_interior_picture(const std::string& path, const InteriorAreas& result) {
  const Crossings& nodes = result.nodes;
  const View view(include(include({}, nodes.curve1().points), nodes.curve2().points));
  std::string svg;
  begin_picture(svg, view, "Paths of the interior method", 4);
  bool shared = false;
  for (const int curve : {1, 2}) {
    const char* const colour = curve_colours[static_cast<std::size_t>(curve - 1)];
    const std::vector<Part> parts = side_parts(nodes, curve);
    add_stroked(svg, colour, 2.4, side_path(view, parts, Side::outside));
    append_all(svg, "<g stroke-dasharray=\"", 9 * subpixels, " ", 6 * subpixels, "\">\n");
    add_stroked(svg, colour, 2.4, side_path(view, parts, Side::inside));
    svg += "</g>\n";
    const std::string on = side_path(view, parts, Side::on);
    shared = shared || !on.empty();
    if (!on.empty()) add_stroked(svg, on_colour, 3.5, on);
    add_arrows(svg, view, parts, colour);
  }
  begin_legend(svg);
  add_legend_entry(svg, view, 0, 0, line_swatch(curve_colours[0], 2.4), "C1 outside of C2, I2 = +1");
  add_legend_entry(svg, view, 1, 0, line_swatch(curve_colours[1], 2.4), "C2 outside of C1, I1 = +1");
  add_legend_entry(svg, view, 0, 1, dashed_swatch(curve_colours[0]), "C1 inside of C2, I2 = \u22121");
  add_legend_entry(svg, view, 1, 1, dashed_swatch(curve_colours[1]), "C2 inside of C1, I1 = \u22121");
  add_legend_entry(svg, view, 0, 2, "", "Q2 = " + rounded(result.q2) + ": along solid lines, the union");
  add_legend_entry(svg, view, 1, 2, "", "Q3 = " + rounded(result.q3) + ": along dashed lines, the intersection");
  add_legend_entry(svg, view, 0, 3, "", "Q1 = " + rounded(result.q1) + ": the one less the other");
  if (shared) add_legend_entry(svg, view, 1, 3, line_swatch(on_colour, 3.5), "shared, I = 0");
  end_picture(svg);
  write_file(path, svg);
}

}  // namespace lober::cli
