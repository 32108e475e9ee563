#include <optional>

#include "engine/base/text.hpp"
#include "engine/operations/escape_choice.hpp"
#include "viewer/palette.hpp"
#include "viewer/scenes/scenes.hpp"
#include "viewer/scenes/tube_overlaps.hpp"

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

Layer fractions_layer(const SystemEscape& found, const std::vector<std::string>& names) {
  Layer layer{.kind = Layer::Kind::areas, .name = "escape by crossings", .one = "part", .colour = palette::common};
  Column fraction{"fraction", {}, {}}, n{"crossings", {}, {}};
  for (const EscapeFraction& row : found.table) {
    if (!row.is_known() || row.fraction == 0) continue;
    const std::optional<TubePair> split = split_for_picture(found, row);
    if (!split) continue;
    layer.areas.push_back(common_part(split->from->view(), split->to->view()));
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
