// The picture of the classes of sigma: numbered crossings with tangents and signs, pieces of C1 \ C2 in the colours of
// their classes, and which way sigma goes.

#include <algorithm>
#include <cmath>

#include "cli/overlay/overlay_report.hpp"
#include "cli/picture/system_figure.hpp"

namespace lober::cli {
namespace {

constexpr std::size_t max_numbered = 60;  // crossings
constexpr std::array<const char*, 6> class_colours{palette::common,  palette::entering,
                                                   palette::leaving, palette::right_of_unstable,
                                                   palette::flux,    palette::left_of_unstable};

// Unit vector along the curve, counter-clockwise, at a position of it.
Point tangent(const CurveView& curve, bool clockwise, const Position& at) {
  const std::size_t n = curve.points.size();
  const Point a = curve.points[at.segment], b = curve.points[(at.segment + 1) % n];
  const double length = std::hypot(b.x - a.x, b.y - a.y), sign = clockwise ? -1 : 1;
  return length > 0 ? Point{sign * (b.x - a.x) / length, sign * (b.y - a.y) / length} : Point{};
}

// The tangents at every crossing along both curves, as rho is defined; `length` in the plane.
std::array<Layer, 2> tangent_layers(const Crossings& nodes, double length) {
  std::array<Layer, 2> layers{line_layer("tangents of C1", "", palette::curve1, 1),
                              line_layer("tangents of C2", "", palette::curve2, 1)};
  for (Layer& layer : layers) layer.arrow_at_end = true;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const Node node = nodes[k];
    if (node.rho == 0) continue;
    const Point from = node.begin;
    const auto add = [&](Layer& layer, Point along) {
      layer.lines.push_back(
          polyline(std::vector<Point>{from, {from.x + length * along.x, from.y + length * along.y}}, false));
    };
    add(layers[0], tangent(nodes.curve1(), nodes.clockwise1(), node.begin1));
    add(layers[1], tangent(nodes.curve2(), nodes.clockwise2(), node.begin2));
  }
  return layers;
}

// The middle of the way from each p to sigma(p) along the boundary of the piece, in the direction of sigma: where it
// follows C1 (rho(p) = +1) into the first layer, where it follows C2 into the second one.
void add_sigma_arrows(std::array<Layer, 2>& layers, const Crossings& nodes, std::span<const Point> loop) {
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
  const auto at = [&](std::size_t vertex) { return loop[vertex % loop.size()]; };
  const auto step = [&](std::size_t vertex) {
    const Point a = at(vertex), b = at(vertex + 1);
    return std::hypot(b.x - a.x, b.y - a.y);
  };
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const std::size_t first = corners[k].first;
    std::size_t last = corners[(k + 1) % corners.size()].first;
    if (last <= first) last += loop.size();
    double length = 0;
    for (std::size_t vertex = first; vertex < last; ++vertex) length += step(vertex);
    double left = 0.5 * length;
    for (std::size_t vertex = first; vertex < last; ++vertex) {
      const double here = step(vertex);
      if (left > here || !(here > 0)) {
        left -= here;
        continue;
      }
      const Point a = at(vertex), b = at(vertex + 1);
      const Point middle{a.x + left / here * (b.x - a.x), a.y + left / here * (b.y - a.y)};
      // A short line whose head is that of the arrow.
      layers[corners[k].second > 0 ? 0 : 1].lines.push_back(
          polyline(std::vector<Point>{{middle.x - 1e-3 * (b.x - a.x), middle.y - 1e-3 * (b.y - a.y)}, middle}, false));
      break;
    }
  }
}

// As Naik, Lekien & Ross (2017) call them: a piece that one arc of each curve bounds, and one with more.
const char* piece_name(std::size_t crossings) {
  return crossings == 2 ? "knob" : "handle";
}

std::string class_text(const std::vector<SigmaStep>& steps, std::size_t number) {
  double sum = 0;
  std::string members;
  std::size_t count = 0;
  for (const SigmaStep& step : steps) {
    if (step.class_number != number) continue;
    sum += step.s;
    if (++count <= 8) members += (members.empty() ? "" : ", ") + std::string("p") + std::to_string(step.crossing);
  }
  if (count > 8) members += ", ...";
  return "class " + std::to_string(number) + " {" + members + "}, half the sum of S " + rounded(sum / 2) + ": a " +
         piece_name(count);
}

}  // namespace

Figure classes_figure(const CurveOverlay& found, const std::array<NamedCurve, 2>& inputs) {
  const Overlay& result = found;
  const Crossings& nodes = result.nodes;
  const std::vector<SigmaStep>& steps = (*found.steps)[0];
  const std::size_t classes = class_count(steps);
  Figure figure = overlay_frame(nodes, inputs);
  figure.what = "Crossings of two curves and their classes";
  std::vector<Layer> fills;
  for (std::size_t k = 0; k < std::max<std::size_t>(classes, 1); ++k) {
    const bool listed = k < class_colours.size() && classes > 0;
    fills.push_back(fill_layer("class " + std::to_string(k), listed ? class_text(steps, k) : "",
                               class_colours[k % class_colours.size()]));
    fills.back().even_odd = true;
  }
  // The class of a loop is that of the first crossing on it.
  for (std::size_t piece = 0; piece < result.pieces(Pairing::c1_minus_c2).size(); ++piece) {
    for (std::vector<Point>& loop : outline(result, Pairing::c1_minus_c2, piece)) {
      std::size_t number = 0;
      for (const SigmaStep& step : steps) {
        const Point at = nodes[step.crossing].begin;
        if (std::find(loop.begin(), loop.end(), at) != loop.end()) number = step.class_number;
      }
      fills[number].lines.push_back(polyline(std::move(loop), true));
    }
  }
  const bool numbered = nodes.crossings() <= max_numbered;
  std::array<Layer, 2> sigma{line_layer("sigma along C1", "sigma along C1, forward", palette::ink, 0.1),
                             line_layer("sigma along C2", "sigma along C2, backward", palette::flux, 0.1)};
  for (Layer& layer : sigma) layer.arrow_at_end = true;
  if (numbered) {
    for (const Layer& fill : fills) {
      for (const Polyline& loop : fill.lines) add_sigma_arrows(sigma, nodes, loop.points());
    }
  }
  for (Layer& fill : fills) figure.layers.push_back(std::move(fill));
  if (classes > class_colours.size()) {
    figure.notes.push_back(std::to_string(classes) + " classes in all; colours repeat");
  }
  const auto add_curve = [&](const char* name, const CurveView& curve, double area, const char* colour, double width) {
    figure.layers.push_back(
        line_layer(name, std::string(name) + " and its tangent, area " + rounded(area), colour, width));
    figure.layers.back().lines.push_back(polyline(curve.points, true));
  };
  add_curve("C1", nodes.curve1(), result.areas.c1, palette::curve1, 0.9);
  add_curve("C2", nodes.curve2(), result.areas.c2, palette::curve2, 0.6);
  if (numbered) {
    for (Layer& layer : tangent_layers(nodes, 0.04 * std::max(figure.window.width(), figure.window.height()))) {
      figure.layers.push_back(std::move(layer));
    }
    for (Layer& layer : sigma) figure.layers.push_back(std::move(layer));
  }
  for (const int rho : {1, -1}) {
    Layer dots = dot_layer(rho > 0 ? "rho = +1" : "rho = -1",
                           rho > 0 ? "rho = +1, C1 leaves A2" : "rho = \u22121, C1 enters A2", {}, 2);
    dots.hollow = rho < 0;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const Node node = nodes[k];
      if (node.rho == rho) dots.points.push_back(node.begin);
    }
    figure.layers.push_back(std::move(dots));
  }
  // Names of the pieces, where they are few.
  for (std::size_t k = 0; k < classes && classes <= class_colours.size(); ++k) {
    const auto crossings = static_cast<std::size_t>(
        std::count_if(steps.begin(), steps.end(), [&](const SigmaStep& step) { return step.class_number == k; }));
    if (figure.layers[k].lines.empty()) continue;
    figure.labels.push_back({.position = FigureLabel::Position::inside,
                             .text = piece_name(crossings),
                             .polygon = figure.layers[k].lines.front(),
                             .size = 6.5});
  }
  for (const SigmaStep& step : steps) {
    if (!numbered) break;
    figure.labels.push_back(
        {.text = "p_{" + std::to_string(step.crossing) + "}", .at = nodes[step.crossing].begin, .radius = 2.5});
  }
  return figure;
}

}  // namespace lober::cli
