// The picture of an overlay: two curves, and the lobes between them in two colours.

#include <algorithm>
#include <cmath>

#include "cli/drawing.hpp"
#include "cli/overlay_report.hpp"
#include "cli/text.hpp"

namespace lober::cli {
namespace {

constexpr double legend_line = 24;
constexpr double legend_height = 2 * legend_line + 12;
constexpr std::size_t most_dots = 500;

constexpr const char* colour1 = "#1f5fa8";
constexpr const char* colour2 = "#c8501e";
constexpr const char* dot_colour = "#222222";

std::string pieces_path(const View& view, const Overlay& result, Pairing pairing) {
  return path_of(view, [&](PathWriter& writer) {
    for (std::size_t k = 0; k < result.pieces(pairing).size(); ++k) {
      for (const std::vector<Point>& polygon : outline(result, pairing, k)) writer.add(polygon);
    }
  });
}

void add_dots(std::string& svg, const View& view, const Crossings& nodes) {
  if (nodes.crossings() >= most_dots) return;
  append_all(svg, "<g fill=\"", dot_colour, "\" stroke=\"#ffffff\" stroke-width=\"", subpixels, "\">\n");
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const Node node = nodes[k];
    if (node.rho == 0) continue;
    const Pixel at = view(node.begin);
    append_all(svg, "<circle cx=\"", subpixel(at.x), "\" cy=\"", subpixel(at.y), "\" r=\"", 3 * subpixels, "\"/>\n");
  }
  svg += "</g>\n";
}

void add_legend(std::string& svg, const OverlayReport& report, double top) {
  const auto entry = [&](double x, double y, const char* swatch, const std::string& text) {
    append_all(svg, "<g transform=\"translate(", x, " ", y, ")\">", swatch,
               "<text x=\"34\" y=\"5\" font-family=\"sans-serif\" font-size=\"15\" fill=\"#333333\">", escaped(text),
               "</text></g>\n");
  };
  const auto line = [](const char* colour) {
    return std::string("<path d=\"M0 0h26\" stroke=\"") + colour + "\" stroke-width=\"2\"/>";
  };
  const auto patch = [](const char* colour) {
    return std::string("<rect y=\"-8\" width=\"26\" height=\"16\" fill=\"") + colour + "\" fill-opacity=\"0.4\"/>";
  };
  const auto pieces = [&](Pairing pairing) {
    const std::size_t count = report.result.pieces(pairing).size();
    return std::to_string(count) + (count == 1 ? " lobe, area " : " lobes, area ");
  };
  const Areas& areas = report.result.areas;
  const double right = margin + width / 2;
  entry(margin, top, line(colour1).c_str(), "C1, area " + rounded(areas.c1));
  entry(right, top, patch(colour1).c_str(), "C1 \\ C2: " + pieces(Pairing::c1_minus_c2) + rounded(areas.c1_minus_c2));
  entry(margin, top + legend_line, line(colour2).c_str(), "C2, area " + rounded(areas.c2));
  entry(right, top + legend_line, patch(colour2).c_str(),
        "C2 \\ C1: " + pieces(Pairing::c2_minus_c1) + rounded(areas.c2_minus_c1));
}

}  // namespace

void write_picture(const std::string& path, const OverlayReport& report) {
  const Overlay& result = report.result;
  const CurveView &c1 = result.nodes.curve1(), &c2 = result.nodes.curve2();
  const std::array<CurveView, 2> curves{c1, c2};
  const View view(curves);
  const double full_width = width + 2 * margin, full_height = view.height() + 2 * margin + legend_height;
  std::string svg;
  append_all(svg, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"", full_width, "\" height=\"", full_height,
             "\" viewBox=\"0 0 ", full_width, " ", full_height, "\">\n", "<title>Lobes between two curves</title>\n",
             "<rect width=\"100%\" height=\"100%\" fill=\"#fbfaf7\"/>\n", "<g transform=\"scale(", 1.0 / subpixels,
             ")\" stroke-linejoin=\"round\">\n");
  const auto fill = [&](Pairing pairing, const char* colour) {
    append_all(svg, "<path fill=\"", colour, "\" fill-opacity=\"0.4\" fill-rule=\"evenodd\" d=\"",
               pieces_path(view, result, pairing), "\"/>\n");
  };
  const auto stroke = [&](const CurveView& curve, const char* colour, double pixels) {
    append_all(svg, "<path fill=\"none\" stroke=\"", colour, "\" stroke-width=\"", pixels * subpixels, "\" d=\"",
               curve_path(view, curve), "\"/>\n");
  };
  fill(Pairing::c1_minus_c2, colour1);
  fill(Pairing::c2_minus_c1, colour2);
  // The first curve is the wider one, so that it can be seen where they share an arc.
  stroke(c1, colour1, 2.4);
  stroke(c2, colour2, 1.2);
  add_dots(svg, view, result.nodes);
  svg += "</g>\n";
  add_legend(svg, report, view.height() + 2 * margin + 8);
  svg += "</svg>\n";
  write_file(path, svg);
}

}  // namespace lober::cli
