#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <span>

#include "engine/base/text.hpp"
#include "lober/base/error.hpp"
#include "viewer/palette.hpp"
#include "viewer/scenes/scenes.hpp"

namespace lober::viewer {
namespace {

using operations::CurveTangle;

constexpr std::size_t max_common_parts = 400;  // pairs of lobes whose common parts are found, the largest ones

Layer manifold_layer(const Tangle& tangle, bool unstable) {
  Layer layer{.kind = Layer::Kind::lines,
              .name = unstable ? "U, unstable manifold" : "S, stable manifold",
              .colour = unstable ? palette::unstable : palette::stable,
              .width = 1.2};
  layer.lines = {{unstable ? "U" : "S", unstable ? tangle.u() : tangle.s()}};
  for (std::size_t k = 0; k < tangle.nodes.size(); ++k) {
    const Node node = tangle.nodes[k];
    for (const Position& at : unstable ? std::array{node.begin1, node.end1} : std::array{node.begin2, node.end2}) {
      layer.lines[0].exact.push_back(at.segment);
    }
  }
  return layer;
}

// Lobes of one orientation: those that leave or those that enter, where the map is known well enough to tell.
Layer lobes_layer(const Tangle& tangle, const CurveTangle* measured, int orientation) {
  const bool known = tangle.images.period != 0;
  const bool leaving = known && orientation == tangle.boundary->orientation;
  Layer layer{.kind = Layer::Kind::areas, .one = "lobe"};
  layer.name = !known    ? (orientation > 0 ? "lobes left of U" : "lobes right of U")
               : leaving ? "L12, lobes that leave"
                         : "L21, lobes that enter";
  layer.colour = !known    ? (orientation > 0 ? palette::left_of_unstable : palette::right_of_unstable)
                 : leaving ? palette::leaving
                           : palette::entering;
  Column area{"area", {}, {}}, n{"n", {}, {}}, inside{"inside", {}, {}}, outside{"outside", {}, {}},
      perimeter{"perimeter", {}, {}}, width{"width", {}, {}};
  for (std::size_t k = 0; k < tangle.lobes.size(); ++k) {
    const Lobe& lobe = tangle.lobes[k];
    if (lobe.orientation() != orientation) continue;
    layer.areas.push_back({lobe_outline(tangle, k)});
    std::string name = "lobe " + std::to_string(k);
    if (known) name += " " + text(tangle.images.labels[k]);
    layer.names.push_back(name);
    area.values.push_back(lobe.area);
    area.bar.push_back(tangle.rounding(lobe.area) +
                       (measured != nullptr ? measured->discretisation(k) : lobe.smooth_error));
    inside.values.push_back(lobe.inside);
    outside.values.push_back(lobe.outside);
    if (known) n.values.push_back(tangle.images.labels[k].n);
    if (measured != nullptr) {
      perimeter.values.push_back(measured->shapes[k].perimeter);
      width.values.push_back(measured->shapes[k].width);
    }
  }
  layer.columns.push_back(std::move(area));
  if (known) {
    layer.iterate_column = 1;
    layer.columns.push_back(std::move(n));
  }
  layer.columns.push_back(std::move(inside));
  layer.columns.push_back(std::move(outside));
  if (measured != nullptr) {
    layer.columns.push_back(std::move(perimeter));
    layer.columns.push_back(std::move(width));
  }
  return layer;
}

// Where the polygons cross, which are what is drawn; smooth curves through the points may cross beside that, which is
// seen far enough in.
Layer pips_layer(const Tangle& tangle) {
  Layer layer{.kind = Layer::Kind::dots, .name = "pips", .one = "pip", .colour = "#222222", .width = 3.5};
  Column rho{"rho", {}, {}}, segment_u{"segment of U", {}, {}}, segment_s{"segment of S", {}, {}},
      smooth_x{"x of smooth curves", {}, {}}, smooth_y{"y of smooth curves", {}, {}};
  bool smooth = false;
  for (std::size_t k = 0; k < tangle.pips.size(); ++k) {
    const Pip& pip = tangle.pips[k];
    layer.dots.push_back(tangle.nodes[pip.node].begin);
    smooth_x.values.push_back(pip.at.x);
    smooth_y.values.push_back(pip.at.y);
    smooth = smooth || pip.at != layer.dots.back();
    layer.names.push_back("pip " + std::to_string(k) +
                          (tangle.boundary && tangle.boundary->bip == k ? ", the bip" : ""));
    rho.values.push_back(pip.rho);
    segment_u.values.push_back(pip.u.segment);
    segment_s.values.push_back(pip.s.segment);
  }
  layer.columns = {std::move(rho), std::move(segment_u), std::move(segment_s)};
  if (smooth) {
    layer.columns.push_back(std::move(smooth_x));
    layer.columns.push_back(std::move(smooth_y));
  }
  return layer;
}

// Crossings that are no pips.
Layer sips_layer(const Tangle& tangle) {
  Layer layer{
      .kind = Layer::Kind::dots, .name = "sips", .one = "sip", .colour = "#8a8f98", .width = 2.5, .shown = false};
  std::set<std::uint32_t> pips;
  for (const Pip& pip : tangle.pips) pips.insert(pip.node);
  const std::vector<ArcsAt> arcs = arcs_at_nodes(tangle);
  Column rho{"rho", {}, {}}, generation{"generation", {}, {}}, lobe_u{"lobe by U", {}, {}}, lobe_s{"lobe by S", {}, {}};
  for (std::uint32_t k = 0; k < tangle.nodes.size(); ++k) {
    const int sign = tangle.nodes.rho(k);
    if (sign == 0 || pips.contains(k)) continue;
    layer.dots.push_back(tangle.nodes[k].begin);
    rho.values.push_back(sign);
    generation.values.push_back(arcs[k].generation());
    lobe_u.values.push_back(arcs[k].u);
    lobe_s.values.push_back(arcs[k].s);
  }
  layer.columns = {std::move(rho), std::move(generation), std::move(lobe_u), std::move(lobe_s)};
  return layer;
}

// The common parts of lobes, the largest pairs first. Lobes that fall into pieces are left out.
Layer common_layer(const Tangle& tangle, std::vector<LobeOverlap> pairs) {
  Layer layer{.kind = Layer::Kind::areas,
              .name = "common parts of lobes",
              .one = "overlap",
              .colour = palette::common,
              .shown = false};
  std::stable_sort(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) { return a.area > b.area; });
  if (pairs.size() > max_common_parts) {
    layer.name += ", the largest " + std::to_string(max_common_parts) + " of " + std::to_string(pairs.size());
    pairs.resize(max_common_parts);
  }
  Column area{"area", {}, {}}, i{"lobe i", {}, {}}, j{"lobe j", {}, {}};
  for (const LobeOverlap& both : pairs) {
    const std::vector<Point> one = lobe_outline(tangle, both.i), other = lobe_outline(tangle, both.j);
    try {
      const Overlay found = overlay(ClosedCurve::borrow(one), ClosedCurve::borrow(other));
      Polygons polygons;
      for (std::size_t k = 0; k < found.pieces(Pairing::intersection).size(); ++k) {
        for (std::vector<Point>& loop : outline(found, Pairing::intersection, k)) polygons.push_back(std::move(loop));
      }
      layer.areas.push_back(std::move(polygons));
    } catch (const NotSimpleError&) {
      continue;
    }
    layer.names.push_back("lobes " + std::to_string(both.i) + " and " + std::to_string(both.j));
    area.values.push_back(both.area);
    area.bar.push_back(both.error);
    i.values.push_back(both.i);
    j.values.push_back(both.j);
  }
  layer.columns = {std::move(area), std::move(i), std::move(j)};
  return layer;
}

Scene scene_of(const Tangle& tangle, const CurveTangle* measured, const std::vector<LobeOverlap>* pairs) {
  Scene scene;
  scene.title = "Tangle of two manifolds";
  if (tangle.boundary) {
    Layer boundary{
        .kind = Layer::Kind::outlines, .name = "boundary", .one = "boundary", .colour = palette::boundary, .width = 5};
    boundary.areas = {{boundary_outline(tangle)}};
    boundary.columns = {
        {"area", {tangle.boundary->area}, {tangle.rounding(tangle.boundary->area) + tangle.boundary->smooth_error}}};
    scene.layers.push_back(std::move(boundary));
  }
  for (const int orientation : {1, -1}) {
    Layer lobes = lobes_layer(tangle, measured, orientation);
    if (lobes.size() > 0) scene.layers.push_back(std::move(lobes));
  }
  if (pairs != nullptr && !pairs->empty()) scene.layers.push_back(common_layer(tangle, *pairs));
  scene.layers.push_back(manifold_layer(tangle, false));
  scene.layers.push_back(manifold_layer(tangle, true));
  Layer sips = sips_layer(tangle);
  if (sips.size() > 0) scene.layers.push_back(std::move(sips));
  if (!tangle.pips.empty()) scene.layers.push_back(pips_layer(tangle));
  return scene;
}

std::string measured_text(const Measured& value) {
  return detail::format_number(value.value) + " +- " + detail::format_rounded(value.error);
}

Scene transport_scene(const Tangle& tangle, const CurveTangle* measured, const std::vector<LobeOverlap>& pairs,
                      std::span<const Region> regions, std::span<const TransportStep> steps) {
  Scene scene = scene_of(tangle, measured, &pairs);
  scene.title = "Transport across the boundary of a tangle";
  for (std::size_t k = 0; k < regions.size(); ++k) {
    if (regions[k].bounded) {
      scene.notes.push_back("Area of R" + std::to_string(k + 1) + ": " + measured_text(regions[k].area));
    }
  }
  for (const TransportStep& step : steps) {
    if (step.flux.size() < 2) continue;
    scene.notes.push_back("n = " + std::to_string(step.n) + ": a12 = " + measured_text(step.flux(0, 1)) +
                          ", T12 = " + measured_text(step.total(0, 1)));
  }
  return scene;
}

}  // namespace

Scene tangle_scene(const CurveTangle& found) {
  return scene_of(found, &found, found.overlaps ? &*found.overlaps : nullptr);
}

Scene transport_scene(const operations::SystemTransport& found) {
  const Tangle& tangle = found.manifolds().tangle;
  const std::vector<LobeOverlap> pairs = overlaps(tangle);
  return transport_scene(tangle, nullptr, pairs, found.regions, found.steps);
}

Scene transport_scene(const CurveTangle& tangle, const operations::CurveTransport& found) {
  const std::vector<LobeOverlap> pairs = overlaps(tangle);
  return transport_scene(tangle, &tangle, pairs, found.regions, found.steps);
}

}  // namespace lober::viewer
