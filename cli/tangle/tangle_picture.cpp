// The picture of a tangle: manifolds, pips, lobes in two colours, boundary. The window fits lobes and boundary.

#include <algorithm>
#include <cmath>
#include <set>

#include "cli/report/labels.hpp"
#include "cli/report/palette.hpp"
#include "cli/report/svg.hpp"
#include "cli/tangle/tangle_report.hpp"

namespace lober::cli {
namespace {

constexpr std::size_t max_tangle_dots = 500;
constexpr double dot_spacing = 5;  // pixels between pips that get a dot

// Lobes of one orientation, and the colour that says what they do.
const char* lobes_colour(const Tangle& tangle, int orientation) {
  if (tangle.images.period != 0) {
    return orientation == tangle.boundary->orientation ? palette::leaving : palette::entering;
  }
  return orientation > 0 ? palette::left_of_unstable : palette::right_of_unstable;
}

Rectangle tangle_window(const Tangle& tangle) {
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
  return path_of(view, max_manifold_path_points, [&](PathWriter& writer) {
    for (std::size_t k = 0; k < order.size() && !writer.full(); ++k) writer.add_polygon(lobe_outline(tangle, order[k]));
  });
}

// Pips gather at the fixed points: those that would hide each other are left out.
void add_pips(std::string& svg, const View& view, const Tangle& tangle) {
  std::vector<Pixel> dots;
  for (const Pip& pip : tangle.pips) {
    const Pixel at = view(pip.at);
    if (dots.empty() || std::hypot(at.x - dots.back().x, at.y - dots.back().y) >= dot_spacing) dots.push_back(at);
  }
  const std::string pixel = std::to_string(subpixels), two_pixels = std::to_string(2 * subpixels);
  if (dots.size() <= max_tangle_dots) {
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

bool in_plot(const View& view, Pixel at) {
  return at.x >= view.left() && at.x <= view.left() + view.width() && at.y >= picture_margin &&
         at.y <= picture_margin + view.height();
}

// Crossings that are no pips: sips.
std::vector<Point> sips_of(const Tangle& tangle) {
  std::set<std::uint32_t> pips;
  for (const Pip& pip : tangle.pips) pips.insert(pip.node);
  std::vector<Point> sips;
  for (std::uint32_t k = 0; k < tangle.nodes.size(); ++k) {
    if (tangle.nodes.rho(k) != 0 && !pips.contains(k)) sips.push_back(tangle.nodes[k].begin);
  }
  return sips;
}

void add_sips(std::string& svg, const View& view, std::span<const Point> sips) {
  if (sips.size() > max_tangle_dots) return;
  svg += "<g fill=\"#fbfaf7\" stroke=\"#222222\" stroke-width=\"" + std::to_string(subpixels) + "\">\n";
  for (const Point& sip : sips) add_dot(svg, view(sip), 2.5);
  svg += "</g>\n";
}

// The bip q, its images under the map as far as they are known, other pips by their numbers.
std::string pip_text(const Tangle& tangle, std::size_t pip) {
  std::string number = "q_{" + std::to_string(pip) + "}";
  if (!tangle.boundary) return number;
  const std::size_t bip = tangle.boundary->bip, period = tangle.images.period;
  if (pip == bip) return "q = " + number;
  const std::size_t distance = pip > bip ? pip - bip : bip - pip;
  if (period == 0 || distance % period != 0) return number;
  const std::size_t power = distance / period;
  if (pip > bip) return power == 1 ? "f(q)" : "f^{" + std::to_string(power) + "}(q)";
  return "f^{\u2212" + std::to_string(power) + "}(q)";
}

// "L12(1)" with its regions as subscript.
std::string lobe_text(const LobeLabel& label) {
  const std::string plain = lober::text(label);
  std::string text = "L_{" + plain.substr(1, 2) + "}" + plain.substr(3);
  if (const std::size_t minus = text.find('-'); minus != std::string::npos) text.replace(minus, 1, "\u2212");
  return text;
}

std::string labels_of(const View& view, const Tangle& tangle, std::span<const Point> sips) {
  constexpr double spacing = 14;         // pixels between pips that get a label
  constexpr std::size_t max_lobes = 24;  // the largest ones
  Labels labels(view);
  labels.avoid(tangle.u().points);
  labels.avoid(tangle.s().points);
  for (const Point& sip : sips) labels.avoid(view(sip), 3);
  const Point from = tangle.u().points.front(), to = tangle.s().points.front();
  for (const Point& saddle : {from, to}) labels.avoid(view(saddle), 4);
  std::vector<std::pair<Pixel, std::size_t>> dots;
  for (std::size_t k = 0; k < tangle.pips.size(); ++k) {
    const Pixel at = view(tangle.pips[k].at);
    if (!in_plot(view, at)) continue;
    labels.avoid(at, 4);
    const bool bip = tangle.boundary && k == tangle.boundary->bip;
    const auto near = [&](const auto& dot) { return std::hypot(at.x - dot.first.x, at.y - dot.first.y) < spacing; };
    if (bip) std::erase_if(dots, near);
    if (bip || std::none_of(dots.begin(), dots.end(), near)) dots.emplace_back(at, k);
  }
  const bool one = from == to;
  if (in_plot(view, view(from))) labels.add_beside(view(from), 5, one ? "p" : "p_{\u2212}", 19);
  if (!one && in_plot(view, view(to))) labels.add_beside(view(to), 5, "p_{+}", 19);
  if (tangle.boundary) {
    const std::vector<Point> boundary = boundary_outline(tangle);
    labels.add_inside(boundary, "R_{1}", 24);
    labels.add_outside(boundary, "R_{2}", 24);
  }
  std::vector<std::size_t> lobes;
  if (tangle.images.period != 0) {
    for (std::size_t k = 0; k < tangle.lobes.size(); ++k) lobes.push_back(k);
  }
  std::stable_sort(lobes.begin(), lobes.end(), [&](std::size_t a, std::size_t b) {
    return std::fabs(tangle.lobes[a].area) > std::fabs(tangle.lobes[b].area);
  });
  if (lobes.size() > max_lobes) lobes.resize(max_lobes);
  std::sort(lobes.begin(), lobes.end());
  for (const std::size_t k : lobes) labels.add_inside(lobe_outline(tangle, k), lobe_text(tangle.images.labels[k]), 15);
  for (const auto& [at, pip] : dots) labels.add_beside(at, 5, pip_text(tangle, pip), 15);
  return labels.drawn();
}

}  // namespace

void write_tangle_picture(const std::string& path, const TangleReport& report, const TanglePicture& options) {
  const Tangle& tangle = report.result();
  const View view(options.window ? *options.window : tangle_window(tangle));
  const std::vector<Point> sips = options.labels ? sips_of(tangle) : std::vector<Point>{};
  std::string svg;
  begin_picture(svg, view, "Tangle of two manifolds", options.labels ? 4 : 3, options.window.has_value());
  if (tangle.boundary) {
    add_stroked(svg, palette::boundary, 6, line_path(view, boundary_outline(tangle), max_manifold_path_points));
  }
  add_filled(svg, lobes_colour(tangle, 1), "nonzero", lobes_path(view, tangle, 1));
  add_filled(svg, lobes_colour(tangle, -1), "nonzero", lobes_path(view, tangle, -1));
  add_stroked(svg, palette::stable, 1.2, line_path(view, tangle.s().points, max_manifold_path_points));
  add_stroked(svg, palette::unstable, 1.2, line_path(view, tangle.u().points, max_manifold_path_points));
  if (options.labels) {
    add_sips(svg, view, sips);
    svg += "<g fill=\"#222222\">\n";
    for (const CurveView& curve : {tangle.u(), tangle.s()}) add_dot(svg, view(curve.points.front()), 4);
    svg += "</g>\n";
  }
  add_pips(svg, view, tangle);
  begin_legend(svg);
  if (options.labels) {
    svg += labels_of(view, tangle, sips);
    add_legend_entry(svg, view, 0, 3, R"(<circle cx="13" r="3" fill="#222222"/>)",
                     std::to_string(tangle.pips.size()) + " pips");
    add_legend_entry(svg, view, 1, 3, R"(<circle cx="13" r="2.5" fill="#fbfaf7" stroke="#222222"/>)",
                     counted(sips.size(), "sip", "sips"));
  }
  add_legend(svg, view, tangle);
  end_picture(svg);
  write_file(path, svg);
}

}  // namespace lober::cli
