// The picture of an escape: the curves on the section, those of unstable tubes in the colour of U, of stable ones in
// that of S.

#include "cli/escape/escape_report.hpp"
#include "cli/picture/system_figure.hpp"
#include "lober/base/error.hpp"
#include "lober/curve/drawing.hpp"
#include "viewer/scenes/tube_overlaps.hpp"

namespace lober::cli {
namespace {

struct Drawn {
  CurveView curve;
  bool entry;
  std::size_t image;
};

// Curves that are crossed in the section's direction, or all if it counts both.
std::vector<Drawn> curves_on_section(const Escape& result) {
  std::vector<Drawn> curves;
  for (const Bottleneck& bottleneck : result.bottlenecks) {
    for (const bool entry : {true, false}) {
      const auto& images = entry ? bottleneck.entry : bottleneck.exit;
      for (std::size_t k = 0; k < images.size(); ++k) {
        if (result.section.direction == 0 || images[k].direction == result.section.direction) {
          curves.push_back({images[k].image, entry, k});
        }
      }
    }
  }
  return curves;
}

void add_overlap(Layer& layer, const ClosedCurve& first, const ClosedCurve& second) {
  for (std::vector<Point>& polygon : viewer::common_part(first, second)) {
    layer.lines.push_back(polyline(std::move(polygon), true));
  }
}

// Each fraction of the table once, where a split of it lies on this side of the section, as even as can be.
Layer overlaps_layer(const Escape& result) {
  Layer layer = fill_layer("overlaps", "what goes from one to the other", palette::common);
  layer.opacity = 0.6;
  for (const EscapeFraction& row : result.table) {
    if (!row.is_known() || row.fraction == 0) continue;
    if (const auto split = viewer::split_for_picture(result, row)) {
      add_overlap(layer, split->from->view(), split->to->view());
    }
  }
  if (result.table.empty()) {
    for (const Bottleneck& from : result.bottlenecks) {
      for (const Bottleneck& to : result.bottlenecks) {
        if (from.entry[0].direction == to.exit[0].direction) {
          add_overlap(layer, from.entry[0].view(), to.exit[0].view());
        }
      }
    }
  }
  return layer;
}

}  // namespace

Figure escape_figure(const EscapeReport& report) {
  const std::vector<Drawn> curves = curves_on_section(report.result());
  if (curves.empty()) throw DataError("no curve crosses the section in its direction");
  Rectangle window;
  for (const Drawn& drawn : curves) window = include(window, drawn.curve.points);
  Figure figure{.what = "Tubes of " + report.system.name + " on a section", .title = system_title(report.system)};
  System system;
  system.flow = report.flow;
  system.section = report.result().section;
  name_axes(figure, system);
  const Rectangle edge =
      add_section_edge(figure, *report.flow, report.result().section, report.result().energy, widened(window, 0.6));
  if (!edge.empty()) {
    window.add({edge.min_x, edge.min_y});
    window.add({edge.max_x, edge.max_y});
  }
  figure.window = with_margin(window);
  Layer overlaps = overlaps_layer(report.result());
  if (!overlaps.lines.empty()) figure.layers.push_back(std::move(overlaps));
  // First curves are thick, later images not.
  for (const bool first : {false, true}) {
    for (const bool entry : {true, false}) {
      Layer layer = line_layer(std::string(entry ? "entrances" : "exits") + (first ? "" : ", images"),
                               entry   ? first ? "unstable tubes, of what enters" : "images of unstable tubes"
                               : first ? "stable tubes, of what leaves"
                                       : "pre-images of stable tubes",
                               entry ? palette::unstable : palette::stable, first ? 1.1 : 0.4);
      for (const Drawn& drawn : curves) {
        if (drawn.entry == entry && (drawn.image == 0) == first) {
          layer.lines.push_back(polyline(drawn.curve.points, true));
        }
      }
      if (!layer.lines.empty()) figure.layers.push_back(std::move(layer));
    }
  }
  return figure;
}

}  // namespace lober::cli
