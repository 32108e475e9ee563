// The picture of an overlay: two curves, and the lobes between them in two colours.

#include "cli/overlay/overlay_report.hpp"
#include "cli/picture/system_figure.hpp"

namespace lober::cli {
namespace {

constexpr std::size_t max_overlay_dots = 500;
constexpr std::size_t max_named_pieces = 30;

Layer pieces_layer(const CurveOverlay& found, Pairing pairing, const char* name, const char* colour) {
  const Overlay& result = found;
  const std::size_t count = result.pieces(pairing).size();
  const double area = pairing == Pairing::c1_minus_c2 ? found.areas.c1_minus_c2 : found.areas.c2_minus_c1;
  Layer layer =
      fill_layer(name, std::string(name) + ": " + counted(count, "lobe", "lobes") + ", area " + rounded(area), colour);
  layer.even_odd = true;
  for (std::size_t k = 0; k < count; ++k) {
    for (std::vector<Point>& loop : outline(result, pairing, k)) {
      layer.lines.push_back(polyline(std::move(loop), true, std::string(name) + " #" + std::to_string(k)));
    }
  }
  return layer;
}

void add_names(Figure& figure, const Layer& pieces, const char* prefix) {
  std::size_t number = 0;
  std::string last;
  for (const Polyline& line : pieces.lines) {
    if (line.name == last) continue;  // a hole
    last = line.name;
    figure.labels.push_back({.position = FigureLabel::Position::inside,
                             .text = prefix + std::to_string(number++),
                             .polygon = polyline(line.points(), true),
                             .size = 6.5});
  }
}

}  // namespace

Figure overlay_frame(const Crossings& nodes, const std::array<NamedCurve, 2>& inputs) {
  Figure figure{.what = "Lobes between two curves"};
  figure.title = "C1 " + short_name(spec_of(inputs[0])) + ", C2 " + short_name(spec_of(inputs[1]));
  name_axes(figure, inputs[0]);
  figure.window = with_margin(include(include({}, nodes.curve1().points), nodes.curve2().points));
  return figure;
}

Layer crossings_layer(const Crossings& nodes) {
  Layer dots = dot_layer("crossings", "", {});
  for (std::size_t k = 0; k < nodes.size() && nodes.crossings() < max_overlay_dots; ++k) {
    const Node node = nodes[k];
    if (node.rho != 0) dots.points.push_back(node.begin);
  }
  dots.legend = dots.points.empty() ? "" : counted(nodes.crossings(), "crossing", "crossings");
  return dots;
}

Figure overlay_figure(const CurveOverlay& found, const std::array<NamedCurve, 2>& inputs, const PictureRequest& how) {
  if (found.steps) return classes_figure(found, inputs);
  const Overlay& result = found;
  const CurveView &c1 = result.nodes.curve1(), &c2 = result.nodes.curve2();
  Figure figure = overlay_frame(result.nodes, inputs);
  figure.layers.push_back(pieces_layer(found, Pairing::c1_minus_c2, "C1 \\ C2", palette::curve1));
  figure.layers.push_back(pieces_layer(found, Pairing::c2_minus_c1, "C2 \\ C1", palette::curve2));
  const std::size_t pieces = result.pieces(Pairing::c1_minus_c2).size() + result.pieces(Pairing::c2_minus_c1).size();
  // The first curve is the wider one, so that it can be seen where they share an arc; many lobes are not to be hidden.
  const double width = pieces > 8 * max_named_pieces ? 0.2 : 0.5;
  figure.layers.push_back(line_layer("C1", "C1, area " + rounded(found.areas.c1), palette::curve1, width + 0.4));
  figure.layers.back().lines.push_back(polyline(c1.points, true));
  figure.layers.push_back(line_layer("C2", "C2, area " + rounded(found.areas.c2), palette::curve2, width));
  figure.layers.back().lines.push_back(polyline(c2.points, true));
  figure.layers.push_back(crossings_layer(result.nodes));
  if (how.labels_for(pieces) && pieces <= 8 * max_named_pieces) {
    add_names(figure, figure.layers[0], "A");
    add_names(figure, figure.layers[1], "B");
  }
  return figure;
}

Figure regions_figure(const CurveRegions& found, const std::array<NamedCurve, 2>& inputs) {
  Figure figure{.what = "Regions of two curves by a fill rule"};
  figure.title = "C1 " + short_name(spec_of(inputs[0])) + ", C2 " + short_name(spec_of(inputs[1]));
  name_axes(figure, inputs[0]);
  Rectangle box;
  for (const NamedCurve& input : inputs) box = include(box, input.curve.points);
  figure.window = with_margin(box);
  struct Part {
    Pairing pairing;
    const char *name, *colour;
    double Areas::*area;
  };
  for (const Part& part : {Part{Pairing::c1_minus_c2, "C1 \\ C2", palette::curve1, &Areas::c1_minus_c2},
                           {Pairing::c2_minus_c1, "C2 \\ C1", palette::curve2, &Areas::c2_minus_c1},
                           {Pairing::intersection, "C1 and C2", palette::common, &Areas::intersection}}) {
    Layer layer = fill_layer(part.name, "", part.colour);
    layer.even_odd = true;
    const RegionPieces pieces = found.regions.pieces(found.rule, part.pairing);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      for (std::vector<Point>& loop : pieces.outline(k)) {
        layer.lines.push_back(polyline(std::move(loop), true, std::string(part.name) + " #" + std::to_string(k)));
      }
    }
    layer.legend = std::string(part.name) + ": " + counted(pieces.size(), "piece", "pieces") + ", area " +
                   rounded(found.areas.*part.area);
    figure.layers.push_back(std::move(layer));
  }
  for (const std::size_t k : {0UL, 1UL}) {
    const char* const name = k == 0 ? "C1" : "C2";
    figure.layers.push_back(line_layer(name, name, k == 0 ? palette::curve1 : palette::curve2, k == 0 ? 0.9 : 0.5));
    figure.layers.back().lines.push_back(polyline(inputs[k].curve.points, true));
  }
  return figure;
}

}  // namespace lober::cli
