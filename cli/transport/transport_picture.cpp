// The pictures of `lober transport`: fluxes over n, and the turnstile with its images in the plane.

#include <algorithm>

#include "cli/report/palette.hpp"
#include "cli/report/plot.hpp"
#include "cli/report/report.hpp"
#include "cli/report/svg.hpp"
#include "cli/transport/transport_report.hpp"
#include "lober/base/error.hpp"
#include "lober/overlay/overlay.hpp"

namespace lober::cli {
namespace {

constexpr std::size_t max_transport_path_points = 5'000;  // points of a path

std::string outlines_path(const View& view, const Tangle& tangle, std::span<const std::size_t> lobes) {
  return path_of(view, max_transport_path_points, [&](PathWriter& writer) {
    for (const std::size_t k : lobes) writer.add_polygon(lobe_outline(tangle, k));
  });
}

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

Rectangle turnstile_window(const Tangle& tangle, std::span<const std::size_t> leaving,
                           std::span<const std::size_t> entering) {
  Rectangle box = include({}, boundary_outline(tangle));
  for (const auto& lobes : {leaving, entering}) {
    for (const std::size_t k : lobes) box = include(box, lobe_outline(tangle, k));
  }
  return box;
}

}  // namespace

void write_transport_curve(const std::string& path, const TransportReport& report) {
  PlotSeries flux{"a(n), area that crosses in step n", palette::flux, {}, true, true};
  PlotSeries total{"T(n), in all", palette::total, {}, true, true};
  for (const TransportStep& step : report.result().steps) {
    flux.points.push_back({static_cast<double>(step.n), step.flux(0, 1).value});
    total.points.push_back({static_cast<double>(step.n), step.total(0, 1).value});
  }
  write_plot(path, {"Transport of " + system_text(report.system),
                    "n, iterates of the map; " + system_text(report.system),
                    {std::move(flux), std::move(total)},
                    {}});
}

void write_transport_picture(const std::string& path, const TransportReport& report,
                             const std::optional<Rectangle>& window) {
  const ManifoldTangle& manifolds = report.manifolds();
  const Tangle& tangle = manifolds.tangle;
  // As the overlaps are computed: nothing is followed for longer than half of the iterates.
  const int n = static_cast<int>(report.result().steps.size()), before = 1 + (n - 1) / 2,
            after = std::max(0, n - 1 - (n - 1) / 2);
  const auto leaving = lobes_between(manifolds, before, 0, true), entering = lobes_between(manifolds, 1, after, false);
  const auto outwards = lobes_between(manifolds, 1, 0, true), inwards = lobes_between(manifolds, 1, 0, false);
  const auto common = common_pieces(tangle, leaving, entering);
  const View view(window ? *window : turnstile_window(tangle, leaving, inwards));
  std::string svg;
  begin_picture(svg, view, "Turnstile of " + system_text(report.system), 4, window.has_value());
  add_stroked(svg, palette::boundary, 6, line_path(view, boundary_outline(tangle), max_transport_path_points));
  add_filled(svg, palette::leaving, "nonzero", outlines_path(view, tangle, leaving));
  add_filled(svg, palette::entering, "nonzero", outlines_path(view, tangle, entering));
  add_filled(svg, palette::leaving, "nonzero", outlines_path(view, tangle, outwards));
  add_filled(svg, palette::entering, "nonzero", outlines_path(view, tangle, inwards));
  add_filled(svg, palette::common, "nonzero", path_of(view, max_transport_path_points, [&](PathWriter& writer) {
               for (const std::vector<Point>& polygon : common) writer.add_polygon(polygon);
             }));
  add_stroked(svg, palette::stable, 1, line_path(view, tangle.s().points, max_transport_path_points));
  add_stroked(svg, palette::unstable, 1, line_path(view, tangle.u().points, max_transport_path_points));
  svg += "<g fill=\"#222222\">\n";
  for (const ConnectingOrbit& orbit : manifolds.orbits) add_dot(svg, view(orbit.at), 4);
  svg += "</g>\n";
  begin_legend(svg);
  add_legend_entry(svg, view, 0, 0, line_swatch(palette::unstable, 2), "U, unstable manifold");
  add_legend_entry(svg, view, 1, 0, line_swatch(palette::stable, 2), "S, stable manifold");
  add_legend_entry(svg, view, 0, 1, line_swatch(palette::boundary, 6),
                   "boundary, area " + rounded(report.result().regions.front().area.value));
  add_legend_entry(svg, view, 1, 1, "<circle cx=\"13\" r=\"4\" fill=\"#222222\"/>", "pips of the turnstile");
  add_legend_entry(svg, view, 0, 2, filled_swatch(palette::leaving),
                   "L12(1), area " + rounded(report.result().boundaries.front().flux12.value) + ", and pre-images");
  add_legend_entry(svg, view, 1, 2, filled_swatch(palette::entering),
                   "L21(1), area " + rounded(report.result().boundaries.front().flux21.value) + ", and images");
  add_legend_entry(svg, view, 0, 3, filled_swatch(palette::common), "what they have in common");
  add_legend_entry(svg, view, 1, 3, "", system_text(report.system));
  end_picture(svg);
  write_file(path, svg);
}

}  // namespace lober::cli
