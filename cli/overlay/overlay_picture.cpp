// The picture of an overlay: two curves, and the lobes between them in two colours.

#include "cli/overlay/overlay_report.hpp"
#include "cli/report/svg.hpp"

namespace lober::cli {
namespace {

constexpr std::size_t max_points = 200'000;
constexpr std::size_t max_dots = 500;

constexpr const char* colour1 = "#1f5fa8";
constexpr const char* colour2 = "#c8501e";

std::string pieces_path(const View& view, const Overlay& result, Pairing pairing) {
  return path_of(view, max_points, [&](PathWriter& writer) {
    for (std::size_t k = 0; k < result.pieces(pairing).size(); ++k) {
      for (const std::vector<Point>& polygon : outline(result, pairing, k)) writer.add_polygon(polygon);
    }
  });
}

std::string curve_path(const View& view, const CurveView& curve) {
  return path_of(view, max_points, [&](PathWriter& writer) { writer.add_polygon(curve.points); });
}

void add_dots(std::string& svg, const View& view, const Crossings& nodes) {
  if (nodes.crossings() >= max_dots) return;
  svg += "<g fill=\"#222222\" stroke=\"#ffffff\" stroke-width=\"" + std::to_string(subpixels) + "\">\n";
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const Node node = nodes[k];
    if (node.rho != 0) add_dot(svg, view(node.begin), 3);
  }
  svg += "</g>\n";
}

void add_legend(std::string& svg, const View& view, const OverlayReport& report) {
  const auto pieces = [&](Pairing pairing) {
    const std::size_t count = report.result.pieces(pairing).size();
    return std::to_string(count) + (count == 1 ? " lobe, area " : " lobes, area ");
  };
  const Areas& areas = report.result.areas;
  add_legend_entry(svg, view, 0, 0, line_swatch(colour1, 2), "C1, area " + rounded(areas.c1));
  add_legend_entry(svg, view, 1, 0, filled_swatch(colour1),
                   "C1 \\ C2: " + pieces(Pairing::c1_minus_c2) + rounded(areas.c1_minus_c2));
  add_legend_entry(svg, view, 0, 1, line_swatch(colour2, 2), "C2, area " + rounded(areas.c2));
  add_legend_entry(svg, view, 1, 1, filled_swatch(colour2),
                   "C2 \\ C1: " + pieces(Pairing::c2_minus_c1) + rounded(areas.c2_minus_c1));
}

}  // namespace

void write_picture(const std::string& path, const OverlayReport& report) {
  const Overlay& result = report.result;
  const CurveView &c1 = result.nodes.curve1(), &c2 = result.nodes.curve2();
  const View view(include(include({}, c1.points), c2.points));
  std::string svg;
  begin_picture(svg, view, "Lobes between two curves", 2);
  add_filled(svg, colour1, "evenodd", pieces_path(view, result, Pairing::c1_minus_c2));
  add_filled(svg, colour2, "evenodd", pieces_path(view, result, Pairing::c2_minus_c1));
  // The first curve is the wider one, so that it can be seen where they share an arc.
  add_stroked(svg, colour1, 2.4, curve_path(view, c1));
  add_stroked(svg, colour2, 1.2, curve_path(view, c2));
  add_dots(svg, view, result.nodes);
  begin_legend(svg);
  add_legend(svg, view, report);
  end_picture(svg);
  write_file(path, svg);
}

}  // namespace lober::cli
