#include <cstdlib>

#include "engine/base/text.hpp"
#include "engine/operations/escape_choice.hpp"
#include "lober/base/error.hpp"
#include "viewer/palette.hpp"
#include "viewer/scenes/scenes.hpp"

namespace lober::viewer {
namespace {

using operations::SystemEscape;

// Curves of tubes that cross the section in its direction, or all if it counts both, by iterate of the map between
// crossings.
Layer tubes_layer(const SystemEscape& found, const std::vector<std::string>& names, bool entry) {
  Layer layer{.kind = Layer::Kind::lines,
              .name = entry ? "unstable tubes and images" : "stable tubes and pre-images",
              .colour = entry ? palette::unstable : palette::stable,
              .width = 1.2};
  for (std::size_t b = 0; b < found.bottlenecks.size(); ++b) {
    const auto& images = entry ? found.bottlenecks[b].entry : found.bottlenecks[b].exit;
    for (std::size_t k = 0; k < images.size(); ++k) {
      if (found.section.direction != 0 && images[k].direction != found.section.direction) continue;
      std::string name = (entry ? "entrance " : "exit ") + names[b];
      if (k > 0) name += (entry ? " f^" : " f^-") + std::to_string(k);
      layer.lines.push_back({name, {images[k].image.points, true}});
      layer.iterates.push_back(entry ? static_cast<int>(k) : -static_cast<int>(k));
    }
  }
  return layer;
}

// Cut images cross themselves, and so do curves of a section that tubes meet more than once: what both wind about is
// common.
Polygons common_part(const ClosedCurve& first, const ClosedCurve& second) {
  Polygons polygons;
  const auto add = [&](Polygons piece) {
    for (std::vector<Point>& ring : piece) polygons.push_back(std::move(ring));
  };
  try {
    const Overlay common = overlay(first, second);
    for (std::size_t k = 0; k < common.pieces(Pairing::intersection).size(); ++k) {
      add(outline(common, Pairing::intersection, k));
    }
  } catch (const NotSimpleError&) {
    const RegionPieces pieces = regions(first, second).pieces(FillRule::nonzero, Pairing::intersection);
    for (std::size_t k = 0; k < pieces.size(); ++k) add(pieces.outline(k));
  }
  return polygons;
}

// The row's split with a curve of the entrance on this side of the section, as even as can be; -1 if there is none.
int split_of(const SystemEscape& found, const EscapeFraction& row) {
  const auto& forward = found.bottlenecks[row.entry].entry;
  const auto& backward = found.bottlenecks[row.exit].exit;
  int best = -1;
  for (int a = 0; a <= row.iterates; ++a) {
    const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(row.iterates - a);
    if (i >= forward.size() || j >= backward.size() || forward[i].direction != found.section.direction) continue;
    if (best < 0 || std::abs(2 * a - row.iterates) < std::abs(2 * best - row.iterates)) best = a;
  }
  return best;
}

Layer fractions_layer(const SystemEscape& found, const std::vector<std::string>& names) {
  Layer layer{.kind = Layer::Kind::areas, .name = "escape by crossings", .one = "part", .colour = palette::common};
  Column fraction{"fraction", {}, {}}, n{"crossings", {}, {}};
  for (const EscapeFraction& row : found.table) {
    if (!row.is_known() || row.fraction == 0) continue;
    const int a = split_of(found, row);
    if (a < 0) continue;
    const TubeCurve& from = found.bottlenecks[row.entry].entry[static_cast<std::size_t>(a)];
    const TubeCurve& to = found.bottlenecks[row.exit].exit[static_cast<std::size_t>(row.iterates - a)];
    layer.areas.push_back(common_part(from.view(), to.view()));
    layer.names.push_back(names[row.entry] + " to " + names[row.exit] + ", n = " + std::to_string(row.crossings));
    fraction.values.push_back(row.fraction);
    fraction.bar.push_back(row.error);
    n.values.push_back(row.crossings);
  }
  layer.columns = {std::move(fraction), std::move(n)};
  return layer;
}

}  // namespace

Scene escape_scene(const SystemEscape& found) {
  const std::vector<std::string> names = detail::table::bottleneck_names(found);
  Scene scene;
  scene.title = "Tubes on a section";
  Layer parts = fractions_layer(found, names);
  if (parts.size() > 0) scene.layers.push_back(std::move(parts));
  for (const bool entry : {true, false}) {
    Layer tubes = tubes_layer(found, names, entry);
    if (tubes.size() > 0) scene.layers.push_back(std::move(tubes));
  }
  for (std::size_t b = 0; b < found.bottlenecks.size(); ++b) {
    const Bottleneck& one = found.bottlenecks[b];
    scene.notes.push_back("Area of entrance and exit " + names[b] + ": " + detail::format_number(one.area) + " +- " +
                          detail::format_rounded(one.area_error));
  }
  return scene;
}

}  // namespace lober::viewer
