#include <array>
#include <limits>

#include "engine/base/parallel/parallel.hpp"
#include "engine/base/text.hpp"
#include "viewer/palette.hpp"
#include "viewer/scenes/scenes.hpp"

namespace lober::viewer {
namespace {

using operations::CurveOverlay;
using operations::CurveRegions;

constexpr const char* colour1 = palette::stable;
constexpr const char* colour2 = palette::unstable;

struct PairingLayer {
  Pairing pairing;
  const char *name, *colour;
  double Areas::*area;
  bool shown;
};
constexpr std::array<PairingLayer, 3> pairing_layers{
    {{Pairing::c1_minus_c2, "C1 \\ C2", colour1, &Areas::c1_minus_c2, true},
     {Pairing::c2_minus_c1, "C2 \\ C1", colour2, &Areas::c2_minus_c1, true},
     {Pairing::intersection, "C1 and C2", palette::common, &Areas::intersection, false}}};

// `count` areas, each by `outline(k)`, in parallel.
template <typename Outline>
std::vector<Polygons> outlines_of(std::size_t count, const Outline& outline) {
  std::vector<Polygons> areas(count);
  detail::for_each_block(count, 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) areas[k] = outline(k);
  });
  return areas;
}

template <typename Pieces, typename Outline>
Layer pieces_layer(const PairingLayer& what, const Pieces& pieces, double total, double total_bar,
                   const Outline& outline) {
  Layer layer{.kind = Layer::Kind::areas, .name = what.name, .one = "lobe", .colour = what.colour, .shown = what.shown};
  layer.areas = outlines_of(pieces.size(), outline);
  Column areas{"area", {}, {}}, holes{"holes", {}, {}};
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const auto piece = pieces[k];
    areas.values.push_back(piece.area);
    // The bound of the total is that of the sums, which every piece is a part of, and of the last rounding.
    areas.bar.push_back(total_bar - total * 0x1p-53 + piece.area * 0x1p-53);
    holes.values.push_back(piece.holes);
  }
  layer.columns = {std::move(areas), std::move(holes)};
  return layer;
}

std::string area_note(const char* name, double area, double bar) {
  return std::string("Area of ") + name + ": " + detail::format_number(area) + " +- " + detail::format_rounded(bar) +
         " rounding";
}

template <typename Numbers>
void add_area_notes(Scene& scene, const Areas& areas, const Numbers& bars) {
  scene.notes.push_back(area_note("C1", areas.c1, bars.c1));
  scene.notes.push_back(area_note("C2", areas.c2, bars.c2));
  scene.notes.emplace_back("Error bars of lobes are bounds on rounding, for the polygons as they are.");
  for (const PairingLayer& what : pairing_layers) {
    scene.notes.push_back(area_note(what.name, areas.*what.area, bars.*what.area));
  }
}

Layer curve_layer(const char* name, const char* colour, double width, CurveView curve) {
  Layer layer{.kind = Layer::Kind::lines, .name = name, .colour = colour, .width = width};
  layer.lines = {{name, curve}};
  return layer;
}

// Points where the curves meet, those that cross or those that do not.
Layer nodes_layer(const CurveOverlay& found, bool crossings) {
  Layer layer{.kind = Layer::Kind::dots,
              .name = crossings ? "crossings" : "touches and shared arcs",
              .one = crossings ? "crossing" : "touch",
              .colour = "#222222",
              .width = 3};
  Column rho{"rho", {}, {}}, sigma_class{"class", {}, {}}, segment1{"segment of C1", {}, {}},
      segment2{"segment of C2", {}, {}}, order2{"order along C2", {}, {}};
  for (std::size_t k = 0; k < found.nodes.size(); ++k) {
    const Node node = found.nodes[k];
    if ((node.rho != 0) != crossings) continue;
    layer.dots.push_back(node.begin);
    if (found.nodes.size() <= 100'000) layer.names.push_back(layer.one + " " + std::to_string(k));
    rho.values.push_back(node.rho);
    const bool has_class = !found.classes.empty() && found.classes[k] != Overlay::no_class;
    sigma_class.values.push_back(has_class ? found.classes[k] : std::numeric_limits<double>::quiet_NaN());
    segment1.values.push_back(node.begin1.segment);
    segment2.values.push_back(node.begin2.segment);
    order2.values.push_back(found.nodes.rank2(k));
  }
  layer.columns = {std::move(rho), std::move(segment1), std::move(segment2), std::move(order2)};
  if (crossings) layer.columns.insert(layer.columns.begin() + 1, std::move(sigma_class));
  return layer;
}

}  // namespace

Scene overlay_scene(const CurveOverlay& found) {
  Scene scene;
  scene.title = "Lobes between two curves";
  add_area_notes(scene, found.areas, found.rounding);
  if (found.has_pieces) {
    for (const PairingLayer& what : pairing_layers) {
      scene.layers.push_back(pieces_layer(what, found.pieces(what.pairing), found.areas.*what.area,
                                          found.rounding.*what.area,
                                          [&](std::size_t k) { return outline(found, what.pairing, k); }));
    }
  }
  // The first curve is the wider one, so that it can be seen where they share an arc.
  scene.layers.push_back(curve_layer("C1", colour1, 2.2, found.nodes.curve1()));
  scene.layers.push_back(curve_layer("C2", colour2, 1.2, found.nodes.curve2()));
  Line &c1 = scene.layers[scene.layers.size() - 2].lines[0], &c2 = scene.layers.back().lines[0];
  for (std::size_t k = 0; k < found.nodes.size(); ++k) {
    const Node node = found.nodes[k];
    for (const Position& at : {node.begin1, node.end1}) c1.exact.push_back(at.segment);
    for (const Position& at : {node.begin2, node.end2}) c2.exact.push_back(at.segment);
  }
  if (found.nodes.crossings() > 0) scene.layers.push_back(nodes_layer(found, true));
  if (found.nodes.size() > found.nodes.crossings()) scene.layers.push_back(nodes_layer(found, false));
  return scene;
}

Scene regions_scene(const CurveRegions& found, CurveView c1, CurveView c2) {
  Scene scene;
  scene.title = "Regions of two curves, by the rule " + std::string(name(found.rule));
  add_area_notes(scene, found.areas, found.rounding);
  if (found.pieces) {
    for (const PairingLayer& what : pairing_layers) {
      const RegionPieces& pieces = (*found.pieces)[static_cast<std::size_t>(what.pairing)];
      scene.layers.push_back(pieces_layer(what, pieces, found.areas.*what.area, found.rounding.*what.area,
                                          [&](std::size_t k) { return pieces.outline(k); }));
    }
  }
  if (!c1.points.empty()) scene.layers.push_back(curve_layer("C1", colour1, 2.2, c1));
  if (!c2.points.empty()) scene.layers.push_back(curve_layer("C2", colour2, 1.2, c2));
  return scene;
}

}  // namespace lober::viewer
