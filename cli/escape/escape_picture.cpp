// The picture of an escape: the curves on the section as Naik, Lekien & Ross (2017) draw them, unstable tubes red,
// stable ones green.

#include <cmath>
#include <cstdlib>
#include <iterator>

#include "cli/escape/escape_report.hpp"
#include "cli/report/svg.hpp"
#include "lober/base/error.hpp"
#include "lober/overlay/overlay.hpp"
#include "lober/overlay/regions.hpp"

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

using Polygons = std::vector<std::vector<Point>>;

// Cut images cross themselves, and so do curves of a section that tubes meet more than once: what both wind
// about is common.
Polygons common_polygons(const ClosedCurve& first, const ClosedCurve& second) {
  Polygons polygons;
  const auto add = [&](Polygons piece) {
    polygons.insert(polygons.end(), std::make_move_iterator(piece.begin()), std::make_move_iterator(piece.end()));
  };
  try {
    const Overlay common = overlay(first, second);
    for (std::size_t k = 0; k < common.pieces(Pairing::intersection).size(); ++k) {
      add(outline(common, Pairing::intersection, k));
    }
  } catch (const NotSimpleError&) {
    const RegionPieces pieces = regions(first, second).pieces(FillRule::nonzero, Pairing::intersection);
    for (std::size_t k = 0; k < pieces.size(); ++k) add(pieces.outline(k));
  }
  return polygons;
}

void add_overlap(std::string& path, const View& view, const ClosedCurve& first, const ClosedCurve& second) {
  const Polygons polygons = common_polygons(first, second);
  path += path_of(view, max_manifold_path_points, [&](PathWriter& writer) {
    for (const std::vector<Point>& polygon : polygons) writer.add_polygon(polygon);
  });
}

// Each fraction of the table once, where a split of it lies on this side of the section, as even as can be.
std::string overlaps_path(const View& view, const Escape& result) {
  std::string path;
  for (const EscapeFraction& row : result.table) {
    if (!row.is_known() || row.fraction == 0) continue;
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

}  // namespace

std::string escape_picture(const EscapeReport& report) {
  const std::vector<Drawn> curves = curves_on_section(report.result());
  if (curves.empty()) throw DataError("no curve crosses the section in its direction");
  Rectangle window;
  for (const Drawn& drawn : curves) window = include(window, drawn.curve.points);
  const View view(window);
  std::string svg;
  begin_picture(svg, view, "Tubes of " + report.system.name + " on a section", 2);
  add_filled(svg, common_colour, "nonzero", overlaps_path(view, report.result()));
  // First curves are thick, later images thinner.
  for (const Drawn& drawn : curves) {
    add_stroked(svg, drawn.entry ? entry_colour : exit_colour, drawn.image == 0 ? 2.2 : 1.0,
                polygon_path(view, drawn.curve.points, max_manifold_path_points));
  }
  begin_legend(svg);
  add_legend_entry(svg, view, 0, 0, line_swatch(entry_colour, 2), "unstable tubes and their images");
  add_legend_entry(svg, view, 1, 0, line_swatch(exit_colour, 2), "stable tubes and their pre-images");
  add_legend_entry(svg, view, 0, 1, filled_swatch(common_colour), "what goes from one to the other");
  end_picture(svg);
  return svg;
}

}  // namespace lober::cli
