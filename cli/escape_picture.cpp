// The picture of an escape: the curves on the section as the paper draws them, unstable tubes red, stable ones green.

#include <cmath>
#include <cstdlib>

#include "cli/drawing.hpp"
#include "cli/escape_report.hpp"
#include "engine/overlay/overlay.hpp"

namespace lober::cli {
namespace {

constexpr const char* entry_colour = "#c0392b";
constexpr const char* exit_colour = "#1e8449";
constexpr const char* common_colour = "#1f3a68";

struct Drawn {
  CurveView curve;
  bool entry;
  std::size_t image;
};

// Curves that are crossed in the section's direction, or all if it counts both.
std::vector<Drawn> curves_on_section(const Escape& result) {
  std::vector<Drawn> curves;
  for (const Bottleneck& neck : result.bottlenecks) {
    for (const bool entry : {true, false}) {
      const auto& images = entry ? neck.entry : neck.exit;
      for (std::size_t k = 0; k < images.size(); ++k) {
        if (result.section.direction == 0 || images[k].direction == result.section.direction) {
          curves.push_back({images[k].view(), entry, k});
        }
      }
    }
  }
  return curves;
}

void add_overlap(std::string& path, const View& view, CurveView first, CurveView second) {
  const Overlay common = overlay(first, second);
  path += path_of(view, [&](PathWriter& writer) {
    for (std::size_t k = 0; k < common.pieces(Pairing::intersection).size(); ++k) {
      for (const std::vector<Point>& polygon : outline(common, Pairing::intersection, k)) writer.add(polygon);
    }
  });
}

// Each fraction of the table once, where a split of it lies on this side of the section, as even as can be.
std::string overlaps_path(const View& view, const Escape& result) {
  std::string path;
  for (const EscapeFraction& row : result.table) {
    if (!row.known() || row.fraction == 0) continue;
    const auto& forward = result.bottlenecks[row.entry].entry;
    const auto& backward = result.bottlenecks[row.exit].exit;
    int best = -1;
    for (int a = 0; a <= row.iterates; ++a) {
      const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(row.iterates - a);
      if (i >= forward.size() || j >= backward.size() || forward[i].direction != result.section.direction) continue;
      if (best < 0 || std::abs(2 * a - row.iterates) < std::abs(2 * best - row.iterates)) best = a;
    }
    if (best >= 0) {
      add_overlap(path, view, forward[static_cast<std::size_t>(best)].view(),
                  backward[static_cast<std::size_t>(row.iterates - best)].view());
    }
  }
  if (result.table.empty()) {
    for (const Bottleneck& from : result.bottlenecks) {
      for (const Bottleneck& to : result.bottlenecks) {
        if (from.entry[0].direction == to.exit[0].direction) {
          add_overlap(path, view, from.entry[0].view(), to.exit[0].view());
        }
      }
    }
  }
  return path;
}

void add_legend(std::string& svg, double top) {
  double x = margin;
  const auto entry = [&](const std::string& swatch, const char* text, double wide) {
    append_all(svg, "<g transform=\"translate(", x, " ", top, ")\">", swatch,
               "<text x=\"34\" y=\"5\" font-family=\"sans-serif\" font-size=\"15\" fill=\"#333333\">", text,
               "</text></g>\n");
    x += wide;
  };
  const auto line = [](const char* colour) {
    return std::string("<path d=\"M0 0h26\" stroke=\"") + colour + "\" stroke-width=\"2\"/>";
  };
  entry(line(entry_colour), "unstable tubes and their images", 290);
  entry(line(exit_colour), "stable tubes and their pre-images", 300);
  entry(std::string("<rect y=\"-8\" width=\"26\" height=\"16\" fill=\"") + common_colour + "\" fill-opacity=\"0.75\"/>",
        "what goes from one to the other", 0);
}

}  // namespace

void write_escape_picture(const std::string& path, const EscapeReport& report) {
  const std::vector<Drawn> curves = curves_on_section(report.result);
  if (curves.empty()) throw DataError("no curve crosses the section in its direction");
  std::vector<CurveView> views;
  for (const Drawn& drawn : curves) views.push_back(drawn.curve);
  const View view(views);
  const double full_width = width + 2 * margin, full_height = view.height() + 2 * margin + 36;
  std::string svg;
  append_all(svg, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"", full_width, "\" height=\"", full_height,
             "\" viewBox=\"0 0 ", full_width, " ", full_height, "\">\n", "<title>Tubes of ",
             escaped(report.system.name), " on a section</title>\n",
             "<rect width=\"100%\" height=\"100%\" fill=\"#fbfaf7\"/>\n", "<g transform=\"scale(", 1.0 / subpixels,
             ")\" stroke-linejoin=\"round\" fill=\"none\">\n");
  append_all(svg, "<path fill=\"", common_colour, "\" fill-opacity=\"0.75\" fill-rule=\"nonzero\" d=\"",
             overlaps_path(view, report.result), "\"/>\n");
  // First curves are thick and lightly filled; later images thinner.
  for (const Drawn& drawn : curves) {
    const char* const colour = drawn.entry ? entry_colour : exit_colour;
    const double pixels = drawn.image == 0 ? 2.2 : 1.0;
    append_all(svg, "<path stroke=\"", colour, "\" stroke-width=\"", pixels * subpixels, "\" fill=\"",
               drawn.image == 0 ? colour : "none", "\" fill-opacity=\"0.12\" d=\"", curve_path(view, drawn.curve),
               "\"/>\n");
  }
  svg += "</g>\n";
  add_legend(svg, view.height() + 2 * margin + 8);
  svg += "</svg>\n";
  write_file(path, svg);
}

}  // namespace lober::cli
