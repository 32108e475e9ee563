// The picture of a tangle: manifolds, saddles, pips, lobes in two colours, boundary. The window shows the boundary and
// where the lobes have their area.

#include <algorithm>
#include <cmath>
#include <set>

#include "cli/picture/area_box.hpp"
#include "cli/picture/system_figure.hpp"
#include "cli/tangle/tangle_figure.hpp"
#include "cli/tangle/tangle_report.hpp"

namespace lober::cli {
namespace {

constexpr std::size_t max_tangle_dots = 2000;
constexpr std::size_t max_named_pips = 40;
constexpr std::size_t max_named_lobes = 60;

// Lobes of one orientation, and the colour that says what they do.
const char* lobes_colour(const Tangle& tangle, int orientation) {
  if (tangle.images.period != 0) {
    return orientation == tangle.boundary->orientation ? palette::leaving : palette::entering;
  }
  return orientation > 0 ? palette::left_of_unstable : palette::right_of_unstable;
}

// "L12, leaving: 4 lobes, mean area 0.39", or without the direction where there is no telling.
std::string lobes_text(const Tangle& tangle, int orientation) {
  double sum = 0;
  std::size_t count = 0;
  for (const Lobe& lobe : tangle.lobes) {
    if (lobe.orientation() != orientation) continue;
    sum += std::fabs(lobe.area);
    ++count;
  }
  if (count == 0) return {};
  std::string text = orientation > 0 ? "left of U: " : "right of U: ";
  if (tangle.images.period != 0) {
    text = orientation == tangle.boundary->orientation ? "L12, leaving: " : "L21, entering: ";
  }
  return text + counted(count, "lobe", "lobes") + ", mean area " + rounded(sum / static_cast<double>(count));
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

// The bip q, its images under the map as far as they are known, other pips by their numbers.
std::string pip_text(const Tangle& tangle, std::size_t pip) {
  std::string number = "q_{" + std::to_string(pip) + "}";
  if (!tangle.boundary) return number;
  const std::size_t bip = tangle.boundary->bip, period = tangle.images.period;
  if (pip == bip) return "q";
  const std::size_t distance = pip > bip ? pip - bip : bip - pip;
  if (period == 0 || distance % period != 0) return number;
  const std::size_t power = distance / period;
  if (pip > bip) return power == 1 ? "f(q)" : "f^{" + std::to_string(power) + "}(q)";
  return "f^{\u2212" + std::to_string(power) + "}(q)";
}

// The lobes of an orientation, the largest first: if there are too many, the smallest are left out.
Layer lobes_layer(const Tangle& tangle, const std::vector<std::vector<Point>>& outlines, int orientation) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t k = 0; k < tangle.lobes.size(); ++k) {
    if (tangle.lobes[k].orientation() == orientation) order.push_back(k);
  }
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::fabs(tangle.lobes[a].area) > std::fabs(tangle.lobes[b].area);
  });
  const bool known = tangle.images.period != 0;
  Layer layer = fill_layer(known             ? lobes_text(tangle, orientation).substr(0, 3)
                           : orientation > 0 ? "left"
                                             : "right",
                           lobes_text(tangle, orientation), lobes_colour(tangle, orientation));
  layer.opacity = 0.55;
  for (const std::uint32_t k : order) {
    layer.lines.push_back(polyline(std::span<const Point>(outlines[k]), true,
                                   known ? lober::text(tangle.images.labels[k]) : std::to_string(k)));
  }
  return layer;
}

void add_labels(Figure& figure, const Tangle& tangle, const std::vector<std::vector<Point>>& outlines) {
  const auto inside = [](std::span<const Point> polygon, std::string text, double size) {
    return FigureLabel{.position = FigureLabel::Position::inside,
                       .text = std::move(text),
                       .polygon = polyline(polygon, true),
                       .size = size};
  };
  if (tangle.boundary) {
    // The bip first, so that it has its name; then the regions.
    const Pip& bip = tangle.pips[tangle.boundary->bip];
    figure.labels.push_back({.text = "q", .at = bip.at, .radius = 2.2});
    std::vector<Point> boundary = boundary_outline(tangle);
    figure.labels.push_back(inside({}, "R_{1}", 9));
    figure.labels.back().polygon = polyline(boundary, true);
    figure.labels.push_back({.position = FigureLabel::Position::outside,
                             .text = "R_{2}",
                             .polygon = polyline(std::move(boundary), true),
                             .size = 9});
  }
  std::vector<std::size_t> lobes;
  for (std::size_t k = 0; k < tangle.lobes.size(); ++k) lobes.push_back(k);
  std::stable_sort(lobes.begin(), lobes.end(), [&](std::size_t a, std::size_t b) {
    return std::fabs(tangle.lobes[a].area) > std::fabs(tangle.lobes[b].area);
  });
  if (lobes.size() > max_named_lobes) lobes.resize(max_named_lobes);
  std::sort(lobes.begin(), lobes.end());
  const bool known = tangle.images.period != 0;
  for (const std::size_t k : lobes) {
    figure.labels.push_back(
        inside(outlines[k], known ? lobe_text(tangle.images.labels[k]) : "L_{" + std::to_string(k) + "}", 7));
  }
  if (tangle.pips.size() > max_named_pips) return;
  for (std::size_t k = 0; k < tangle.pips.size(); ++k) {
    if (tangle.boundary && k == tangle.boundary->bip) continue;
    figure.labels.push_back({.text = pip_text(tangle, k), .at = tangle.pips[k].at, .radius = 1.8, .size = 6.5});
  }
}

}  // namespace

std::string lobe_text(const LobeLabel& label) {
  const std::string plain = lober::text(label);
  std::string text = "L_{" + plain.substr(1, 2) + "}" + plain.substr(3);
  if (const std::size_t minus = text.find('-'); minus != std::string::npos) text.replace(minus, 1, "\u2212");
  return text;
}

void add_manifolds(Figure& figure, const Tangle& tangle) {
  const auto add = [&](const char* name, const char* legend, const char* colour, std::span<const Point> points) {
    figure.layers.push_back(line_layer(name, legend, colour, 0.5));
    figure.layers.back().lines.push_back(polyline(points, false, name));
  };
  add("S", "S, stable manifold", palette::stable, tangle.s().points);
  add("U", "U, unstable manifold", palette::unstable, tangle.u().points);
}

void add_boundary(Figure& figure, const Tangle& tangle, double area) {
  figure.layers.push_back(line_layer("boundary", "boundary, area " + rounded(area), palette::boundary, 2.4));
  // From saddle to saddle nothing is drawn, unless a path is given along which the region is closed: its last leg too.
  figure.layers.back().lines.push_back(polyline(boundary_outline(tangle), !tangle.closure.empty()));
}

void add_saddles(Figure& figure, const Tangle& tangle, bool names) {
  const Point from = tangle.u().points.front(), to = tangle.s().points.front();
  Layer saddles = dot_layer("saddles", from == to ? "saddle" : "saddles", {from}, 1.8);
  saddles.shape = DotShape::square;
  if (!(from == to)) saddles.points.push_back(to);
  figure.layers.push_back(std::move(saddles));
  if (!names) return;
  figure.labels.push_back({.text = from == to ? "p" : "p_{\u2212}", .at = from, .radius = 2.2, .size = 8});
  if (!(from == to)) figure.labels.push_back({.text = "p_{+}", .at = to, .radius = 2.2, .size = 8});
}

Figure tangle_figure(const TangleReport& report, const PictureRequest& how) {
  const Tangle& tangle = report.result();
  Figure figure{.what = "Tangle of two manifolds"};
  if (report.origin) {
    figure.title = system_title(report.origin->system->info);
    name_axes(figure, *report.origin->system);
  } else {
    figure.title = "U " + short_name(spec_of(report.inputs[0])) + ", S " + short_name(spec_of(report.inputs[1]));
    name_axes(figure, report.inputs[0]);
  }
  std::vector<std::vector<Point>> outlines;
  for (std::size_t k = 0; k < tangle.lobes.size(); ++k) outlines.push_back(lobe_outline(tangle, k));
  Rectangle window = area_box(outlines);
  if (tangle.boundary) window = box_about(include({}, boundary_outline(tangle)), window);
  if (window.empty()) window = include(include({}, tangle.u().points), tangle.s().points);
  figure.window = with_margin(window);
  if (tangle.boundary) add_boundary(figure, tangle, tangle.boundary->area);
  figure.layers.push_back(lobes_layer(tangle, outlines, 1));
  figure.layers.push_back(lobes_layer(tangle, outlines, -1));
  add_manifolds(figure, tangle);
  const bool labels = how.labels_for(tangle.lobes.size());
  if (labels) {
    const std::vector<Point> sips = sips_of(tangle);
    if (!sips.empty() && sips.size() <= max_tangle_dots) {
      figure.layers.push_back(dot_layer("sips", counted(sips.size(), "sip", "sips"), sips, 0.9));
      figure.layers.back().hollow = true;
    }
  }
  add_saddles(figure, tangle, labels);
  std::vector<Point> pips;
  for (const Pip& pip : tangle.pips) pips.push_back(pip.at);
  if (!pips.empty() && pips.size() <= max_tangle_dots) {
    figure.layers.push_back(dot_layer("pips", counted(pips.size(), "pip", "pips"), pips, 1.3));
  }
  if (tangle.boundary) {
    const std::size_t bip = tangle.boundary->bip;
    figure.layers.push_back(dot_layer("bip", "bip q, pip " + std::to_string(bip), {tangle.pips[bip].at}, 1.8));
    figure.layers.back().hollow = true;
  }
  if (labels) add_labels(figure, tangle, outlines);
  // The outlines are this function's: those that layers and labels borrow become theirs.
  const auto keep = [](Polyline& line) {
    if (!line.borrowed.empty()) line.own.assign(line.borrowed.begin(), line.borrowed.end());
    line.borrowed = {};
  };
  for (Layer& layer : figure.layers) {
    if (layer.kind == LayerKind::fill) std::for_each(layer.lines.begin(), layer.lines.end(), keep);
  }
  for (FigureLabel& label : figure.labels) keep(label.polygon);
  return figure;
}

}  // namespace lober::cli
