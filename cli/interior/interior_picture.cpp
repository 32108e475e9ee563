// The picture of the paths of Q1, Q2 and Q3: the parts of two curves outside and inside of each other.

#include <algorithm>
#include <array>
#include <cmath>

#include "cli/interior/interior_report.hpp"
#include "cli/picture/system_figure.hpp"
#include "cli/report/report.hpp"

namespace lober::cli {
namespace {

constexpr double arrow_spacing = 34;  // points of print along a curve

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

Layer side_layer(std::vector<Part>& parts, Side side, const char* name, const char* legend, const char* colour) {
  Layer layer = line_layer(name, legend, colour, 0.9);
  layer.dashed = side == Side::inside;
  if (side == Side::on) layer.width = 1.4;
  layer.arrows = arrow_spacing;  // in the direction in which the integrals run
  for (Part& part : parts) {
    if (part.side == side) layer.lines.push_back(polyline(std::move(part.line), false));
  }
  return layer;
}

}  // namespace

Figure interior_figure(const InteriorAreas& result, const std::array<NamedCurve, 2>& inputs) {
  const Crossings& nodes = result.nodes;
  Figure figure{.what = "Paths of the interior method"};
  figure.title = "C1 " + short_name(spec_of(inputs[0])) + ", C2 " + short_name(spec_of(inputs[1]));
  name_axes(figure, inputs[0]);
  figure.window = with_margin(include(include({}, nodes.curve1().points), nodes.curve2().points));
  std::vector<Part> c1 = side_parts(nodes, 1), c2 = side_parts(nodes, 2);
  const auto add = [&](std::vector<Part>& parts, Side side, const char* name, const char* legend, const char* colour) {
    Layer layer = side_layer(parts, side, name, legend, colour);
    if (!layer.lines.empty()) figure.layers.push_back(std::move(layer));
  };
  add(c1, Side::outside, "C1 outside", "C1 outside of C2, I2 = +1", palette::curve1);
  add(c2, Side::outside, "C2 outside", "C2 outside of C1, I1 = +1", palette::curve2);
  add(c1, Side::inside, "C1 inside", "C1 inside of C2, I2 = \u22121", palette::curve1);
  add(c2, Side::inside, "C2 inside", "C2 inside of C1, I1 = \u22121", palette::curve2);
  add(c1, Side::on, "shared", "shared, I = 0", palette::shared);
  figure.notes = {"Q2 = " + rounded(result.q2) + ": along solid lines, the union",
                  "Q3 = " + rounded(result.q3) + ": along dashed lines, the intersection",
                  "Q1 = " + rounded(result.q1) + ": the one less the other"};
  return figure;
}

}  // namespace lober::cli
