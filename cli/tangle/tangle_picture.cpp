// The picture of a tangle: manifolds, pips, lobes in two colours, boundary. The window fits lobes and boundary.

#include <algorithm>
#include <cmath>

#include "cli/report/palette.hpp"
#include "cli/report/svg.hpp"
#include "cli/tangle/tangle_report.hpp"

namespace lober::cli {
namespace {

constexpr std::size_t max_points = 14'000;  // of a path: five paths stay below a megabyte
constexpr std::size_t max_dots = 500;
constexpr double dot_spacing = 5;  // pixels between pips that get a dot

// Lobes of one orientation, and the colour that says what they do.
const char* lobes_colour(const Tangle& tangle, int orientation) {
  if (tangle.images.period != 0) {
    return orientation == tangle.boundary->orientation ? palette::leaving : palette::entering;
  }
  return orientation > 0 ? palette::left_of_unstable : palette::right_of_unstable;
}

Rectangle window_of(const Tangle& tangle) {
  if (!tangle.boundary) return include(include({}, tangle.u().points), tangle.s().points);
  Rectangle box = include({}, boundary_outline(tangle));
  for (std::size_t k = 0; k < tangle.lobes.size(); ++k) box = include(box, lobe_outline(tangle, k));
  return box;
}

// All lobes of one orientation run the same way round, so overlaps stay filled by the nonzero rule. The largest come
// first: if there are too many, the smallest are left out.
std::string lobes_path(const View& view, const Tangle& tangle, int orientation) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t k = 0; k < tangle.lobes.size(); ++k) {
    if (tangle.lobes[k].orientation() == orientation) order.push_back(k);
  }
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::fabs(tangle.lobes[a].area) > std::fabs(tangle.lobes[b].area);
  });
  return path_of(view, max_points, [&](PathWriter& writer) {
    for (std::size_t k = 0; k < order.size() && !writer.full(); ++k) writer.add_polygon(lobe_outline(tangle, order[k]));
  });
}

std::string line_path(const View& view, std::span<const Point> points) {
  return path_of(view, max_points, [&](PathWriter& writer) { writer.add_line(points); });
}

// Pips gather at the fixed points: those that would hide each other are left out.
void add_pips(std::string& svg, const View& view, const Tangle& tangle) {
  std::vector<Pixel> dots;
  for (const Pip& pip : tangle.pips) {
    const Pixel at = view(pip.at);
    if (dots.empty() || std::hypot(at.x - dots.back().x, at.y - dots.back().y) >= dot_spacing) dots.push_back(at);
  }
  const std::string pixel = std::to_string(subpixels), two_pixels = std::to_string(2 * subpixels);
  if (dots.size() <= max_dots) {
    svg += "<g fill=\"#222222\" stroke=\"#ffffff\" stroke-width=\"" + pixel + "\">\n";
    for (const Pixel& dot : dots) add_dot(svg, dot, 3);
    svg += "</g>\n";
  }
  if (!tangle.boundary) return;
  svg += "<g fill=\"#ffffff\" stroke=\"#222222\" stroke-width=\"" + two_pixels + "\">\n";
  add_dot(svg, view(tangle.pips[tangle.boundary->bip].at), 5);
  svg += "</g>\n";
}

// "L12: 4 lobes, mean area 0.39", or without the direction where there is no telling.
std::string lobes_text(const Tangle& tangle, int orientation) {
  double sum = 0;
  std::size_t count = 0;
  for (const Lobe& lobe : tangle.lobes) {
    if (lobe.orientation() != orientation) continue;
    sum += std::fabs(lobe.area);
    ++count;
  }
  std::string text = orientation > 0 ? "left of U: " : "right of U: ";
  if (tangle.images.period != 0) {
    text = orientation == tangle.boundary->orientation ? "L12, leaving: " : "L21, entering: ";
  }
  text += counted(count, "lobe", "lobes");
  if (count > 0) text += ", mean area " + rounded(sum / static_cast<double>(count));
  return text;
}

void add_legend(std::string& svg, const View& view, const Tangle& tangle) {
  add_legend_entry(svg, view, 0, 0, line_swatch(palette::unstable, 2), "U, unstable manifold");
  add_legend_entry(svg, view, 0, 1, line_swatch(palette::stable, 2), "S, stable manifold");
  add_legend_entry(svg, view, 1, 0, filled_swatch(lobes_colour(tangle, 1)), lobes_text(tangle, 1));
  add_legend_entry(svg, view, 1, 1, filled_swatch(lobes_colour(tangle, -1)), lobes_text(tangle, -1));
  if (!tangle.boundary) return;
  add_legend_entry(svg, view, 0, 2, line_swatch(palette::boundary, 6),
                   "boundary, area " + rounded(tangle.boundary->area));
  add_legend_entry(svg, view, 1, 2, R"(<circle cx="13" r="5" fill="#ffffff" stroke="#222222" stroke-width="2"/>)",
                   "bip, pip " + std::to_string(tangle.boundary->bip) + " of " + std::to_string(tangle.pips.size()));
}

}  // namespace

void write_tangle_picture(const std::string& path, const TangleReport& report) {
  const Tangle& tangle = report.result;
  const View view(window_of(tangle));
  std::string svg;
  begin_picture(svg, view, "Tangle of two manifolds", 3);
  if (tangle.boundary) {
    add_stroked(svg, palette::boundary, 6, line_path(view, boundary_outline(tangle)));
  }
  add_filled(svg, lobes_colour(tangle, 1), "nonzero", lobes_path(view, tangle, 1));
  add_filled(svg, lobes_colour(tangle, -1), "nonzero", lobes_path(view, tangle, -1));
  add_stroked(svg, palette::stable, 1.2, line_path(view, tangle.s().points));
  add_stroked(svg, palette::unstable, 1.2, line_path(view, tangle.u().points));
  add_pips(svg, view, tangle);
  begin_legend(svg);
  add_legend(svg, view, tangle);
  end_picture(svg);
  write_file(path, svg);
}

}  // namespace lober::cli
