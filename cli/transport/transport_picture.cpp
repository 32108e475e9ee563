// The pictures of `lober transport`: fluxes over n, and the turnstile with its images in the plane.

#include <algorithm>

#include "cli/picture/area_box.hpp"
#include "cli/picture/system_figure.hpp"
#include "cli/tangle/tangle_figure.hpp"
#include "cli/transport/transport_report.hpp"
#include "lober/base/error.hpp"
#include "lober/overlay/overlay.hpp"

namespace lober::cli {
namespace {

// The lobes from f^-before(q) to f^after(q) that leave the region, or that enter it.
std::vector<std::size_t> lobes_between(const ManifoldTangle& manifolds, int before, int after, bool leaving) {
  std::vector<std::size_t> lobes;
  for (std::size_t k = manifolds.image_of_bip(-before); k < manifolds.image_of_bip(after); ++k) {
    if ((manifolds.tangle.images.labels[k].from == 1) == leaving) lobes.push_back(k);
  }
  return lobes;
}

// The common parts of lobes of the two lists, as polygons. Lobes that fall into pieces are left out.
std::vector<std::vector<Point>> common_pieces(const Tangle& tangle, std::span<const std::size_t> first,
                                              std::span<const std::size_t> second) {
  std::vector<std::vector<Point>> polygons;
  for (const LobeOverlap& both : overlaps(tangle)) {
    const auto in = [](std::span<const std::size_t> list, std::size_t k) {
      return std::find(list.begin(), list.end(), k) != list.end();
    };
    if (!(in(first, both.i) && in(second, both.j)) && !(in(first, both.j) && in(second, both.i))) continue;
    const std::vector<Point> one = lobe_outline(tangle, both.i), other = lobe_outline(tangle, both.j);
    try {
      const Overlay found = overlay(ClosedCurve::borrow(one), ClosedCurve::borrow(other));
      const std::size_t pieces = found.pieces(Pairing::intersection).size();
      for (std::size_t k = 0; k < pieces; ++k) {
        for (std::vector<Point>& loop : outline(found, Pairing::intersection, k)) polygons.push_back(std::move(loop));
      }
    } catch (const NotSimpleError&) {
      continue;
    }
  }
  return polygons;
}

Layer lobes_layer(const Tangle& tangle, std::span<const std::size_t> lobes, const char* name, std::string legend,
                  const char* colour, double opacity) {
  Layer layer = fill_layer(name, std::move(legend), colour);
  layer.opacity = opacity;
  for (const std::size_t k : lobes) {
    layer.lines.push_back(polyline(lobe_outline(tangle, k), true, text(tangle.images.labels[k])));
  }
  return layer;
}

}  // namespace

Figure fluxes_figure(const TransportReport& report) {
  Figure figure{.what = "Fluxes over n", .title = system_title(report.system.info)};
  figure.plane = false;
  figure.zero_line = true;
  figure.x = {"n", "", true};
  figure.y = {"area"};
  const auto layer = [](const char* name, const char* legend, const char* colour, DotShape shape) {
    Layer made = dot_layer(name, legend, {}, 1.7);
    made.colour = colour;
    made.shape = shape;
    return made;
  };
  Layer flux = layer("a12(n)", "a(n), area that crosses in step n", palette::flux, DotShape::circle);
  Layer total = layer("T12(n)", "T(n), in all, by lobes", palette::total, DotShape::circle);
  Layer boundaries = layer("T12(n) by boundaries", "T(n) by boundaries", palette::total, DotShape::square);
  Layer particles = layer("T12(n) by particles", "T(n) by particles", palette::estimate, DotShape::triangle);
  boundaries.hollow = true;
  boundaries.radius = 2.6;
  particles.hollow = true;
  Rectangle box;
  const auto add = [&](Layer& to, int n, Measured measured) {
    if (!std::isfinite(measured.value)) return;
    const Point at{static_cast<double>(n), measured.value};
    to.points.push_back(at);
    to.errors.push_back(measured.error);
    const double error = std::isfinite(measured.error) ? measured.error : 0;
    box = include(box, std::array{Point{at.x, 0}, Point{at.x, at.y - error}, Point{at.x, at.y + error}});
  };
  for (const TransportStep& step : report.result().steps) {
    add(flux, step.n, step.flux(0, 1));
    add(total, step.n, step.total(0, 1));
    if (step.by_boundaries.size() > 1) add(boundaries, step.n, step.by_boundaries(0, 1));
    if (step.by_particles.size() > 1) add(particles, step.n, step.by_particles(0, 1));
  }
  for (const Layer* dots : {&flux, &total}) {
    Layer line = line_layer(dots->name, "", dots->colour, 0.6);
    line.lines.push_back(polyline(dots->points, false));
    figure.layers.push_back(std::move(line));
  }
  for (Layer* dots : {&boundaries, &flux, &total, &particles}) {
    if (!dots->points.empty()) figure.layers.push_back(std::move(*dots));
  }
  figure.notes.push_back("bars: errors as in the table; most are smaller than the dots");
  if (!box.empty()) figure.window = widened_plot(box);
  return figure;
}

Rectangle widened_plot(const Rectangle& box) {
  Rectangle window = box;
  const double x = box.width() > 0 ? 0.04 * box.width() : 0.5, y = box.height() > 0 ? 0.05 * box.height() : 0.5;
  window.min_x -= x;
  window.max_x += x;
  if (box.min_y < 0) window.min_y -= y;
  window.max_y += y;
  return window;
}

Figure turnstile_figure(const TransportReport& report, const PictureRequest& how) {
  const ManifoldTangle& manifolds = report.manifolds();
  const Tangle& tangle = manifolds.tangle;
  // As the overlaps are computed: nothing is followed for longer than half of the iterates.
  const int n = static_cast<int>(report.result().steps.size()), before = 1 + (n - 1) / 2,
            after = std::max(0, n - 1 - (n - 1) / 2);
  const auto leaving = lobes_between(manifolds, before, 0, true), entering = lobes_between(manifolds, 1, after, false);
  const auto outwards = lobes_between(manifolds, 1, 0, true), inwards = lobes_between(manifolds, 1, 0, false);
  Figure figure{.what = "Turnstile of " + report.system.info.name, .title = system_title(report.system.info)};
  name_axes(figure, report.system);
  std::vector<std::vector<Point>> shown{boundary_outline(tangle)};
  for (const auto* lobes : {&leaving, &inwards}) {
    for (const std::size_t k : *lobes) shown.push_back(lobe_outline(tangle, k));
  }
  figure.window = with_margin(box_about(include({}, shown.front()), area_box(shown)));
  const TransportBoundary& first = report.result().boundaries.front();
  add_boundary(figure, tangle, report.result().regions.front().area.value);
  const auto add = [&](std::span<const std::size_t> lobes, const char* name, const std::string& legend,
                       const char* colour, double opacity) {
    figure.layers.push_back(lobes_layer(tangle, lobes, name, legend, colour, opacity));
  };
  const auto others = [](const std::vector<std::size_t>& all, const std::vector<std::size_t>& without) {
    std::vector<std::size_t> rest;
    std::copy_if(all.begin(), all.end(), std::back_inserter(rest),
                 [&](std::size_t k) { return std::find(without.begin(), without.end(), k) == without.end(); });
    return rest;
  };
  const auto pre_images = others(leaving, outwards), images = others(entering, inwards);
  if (!pre_images.empty()) add(pre_images, "pre-images of L12(1)", "its pre-images", palette::leaving, 0.3);
  if (!images.empty()) add(images, "images of L21(1)", "its images", palette::entering, 0.3);
  add(outwards, "L12(1)", "L12(1), leaves, area " + rounded(first.flux12.value), palette::leaving, 0.75);
  add(inwards, "L21(1)", "L21(1), enters, area " + rounded(first.flux21.value), palette::entering, 0.75);
  Layer common = fill_layer("overlaps", "overlaps", palette::common);
  common.opacity = 0.8;
  for (std::vector<Point>& polygon : common_pieces(tangle, leaving, entering)) {
    common.lines.push_back(polyline(std::move(polygon), true));
  }
  if (!common.lines.empty()) figure.layers.push_back(std::move(common));
  add_manifolds(figure, tangle);
  const bool labels = how.labels_for(leaving.size() + entering.size());
  add_saddles(figure, tangle, labels);
  Layer pips = dot_layer("pips", "pips of the turnstile", {}, 1.3);
  for (const ConnectingOrbit& orbit : manifolds.orbits) pips.points.push_back(orbit.at);
  figure.layers.push_back(std::move(pips));
  if (tangle.boundary) {
    figure.layers.push_back(dot_layer("bip", "bip q", {tangle.pips[tangle.boundary->bip].at}, 1.8));
    figure.layers.back().hollow = true;
    if (labels) figure.labels.push_back({.text = "q", .at = tangle.pips[tangle.boundary->bip].at, .radius = 2.2});
  }
  if (!labels) return figure;
  const auto name_lobes = [&](std::span<const std::size_t> lobes, double size) {
    for (const std::size_t k : lobes) {
      figure.labels.push_back({.position = FigureLabel::Position::inside,
                               .text = lobe_text(tangle.images.labels[k]),
                               .polygon = polyline(lobe_outline(tangle, k), true),
                               .size = size});
    }
  };
  name_lobes(outwards, 7.5);
  name_lobes(inwards, 7.5);
  name_lobes(pre_images, 6.5);
  name_lobes(images, 6.5);
  return figure;
}

}  // namespace lober::cli
