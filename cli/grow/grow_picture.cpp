// The picture of a manifold that was grown: its images in turn, the saddle, and where the tolerance is not met.

#include <algorithm>
#include <cmath>

#include "cli/grow/grow_report.hpp"
#include "cli/picture/system_figure.hpp"
#include "cli/report/growth_diagnostics.hpp"
#include "cli/report/report.hpp"
#include "lober/curve/drawing.hpp"

namespace lober::cli {
namespace {

constexpr std::size_t max_named_ends = 30, max_ends = 2000;
constexpr double max_share_of_own = 3;  // sides of the system's own window

const char* growth_symbol_text(GrowthDiagnosticCause cause) {
  switch (cause) {
    case GrowthDiagnosticCause::failed:
      return "the map fails";
    case GrowthDiagnosticCause::spacing:
      return "spacing at rounding";
    case GrowthDiagnosticCause::max_rounds:
      return "tolerance not met";
    case GrowthDiagnosticCause::left_box:
      return "outside of the box";
  }
  return "";
}

// The points with which each image of the local manifold ends.
std::vector<Point> image_ends(const GrownManifold& manifold) {
  std::vector<Point> ends;
  for (std::size_t k = 1; k < manifold.generation_begin.size(); ++k) {
    const std::size_t end = std::min(manifold.generation_begin[k], manifold.points.size());
    if (end > 0) ends.push_back(manifold.points[end - 1]);
  }
  return ends;
}

// The first points of segments with this diagnostic.
Layer growth_diagnostic_layer(const GrownManifold& manifold, GrowthDiagnosticCause cause) {
  Layer layer = dot_layer(std::string(name(cause)), "", {}, 1.5);
  layer.shape = DotShape::cross;
  for (const GrowthDiagnostic& diagnostic : manifold.diagnostics) {
    if (diagnostic.cause != cause) continue;
    for (std::size_t k = diagnostic.first; k < diagnostic.first + diagnostic.count && k < manifold.points.size(); ++k) {
      layer.points.push_back(manifold.points[k]);
    }
  }
  layer.legend = counted(layer.points.size(), "segment: ", "segments: ") + growth_symbol_text(cause);
  return layer;
}

Rectangle box_of_points_in(const Rectangle& box, std::span<const Point> points) {
  Rectangle found;
  for (const Point& p : points) {
    if (box.contains(p)) found.add(p);
  }
  return found.empty() ? box : found;
}

// The part of the manifold in the box in which the tolerance holds. Without one all of it, or where it goes far beyond
// the system's own window, the part about that.
Rectangle growth_window(const System& system, std::span<const Point> points, const Rectangle& box) {
  if (!box.empty()) return box_of_points_in(box, points);
  const Rectangle all = include({}, points), &own = system.picture;
  const bool is_far = own.width() > 0 && own.height() > 0 &&
                      (all.width() > max_share_of_own * own.width() || all.height() > max_share_of_own * own.height());
  return is_far ? box_of_points_in(widened(own, 0.25), points) : all;
}

}  // namespace

Figure grow_figure(const System& system, const operations::SystemManifold& manifold, const Rectangle& box,
                   const PictureRequest& how) {
  const bool unstable = manifold.local.side == ManifoldSide::unstable;
  Figure figure{.what = "A manifold of a saddle", .title = system_title(system.info)};
  name_axes(figure, system);
  figure.window = with_margin(growth_window(system, manifold.points, box));
  const std::string side = unstable ? "U, unstable manifold" : "S, stable manifold";
  figure.layers.push_back(line_layer(unstable ? "U" : "S", side + ", length " + rounded(manifold.length),
                                     unstable ? palette::unstable : palette::stable, 0.6));
  figure.layers.back().lines.push_back(polyline(std::span<const Point>(manifold.points), false));
  for (const GrowthDiagnosticCause cause : all_growth_causes) {
    const std::size_t segments = segments_with(manifold.diagnostics, cause);
    if (segments == 0) continue;
    if (cause == GrowthDiagnosticCause::left_box) {
      figure.notes.push_back(counted(segments, "segment", "segments") + " outside of the box, coarse");
    } else {
      figure.layers.push_back(growth_diagnostic_layer(manifold, cause));
    }
  }
  const std::vector<Point> ends = image_ends(manifold);
  const std::size_t images = ends.empty() ? 0 : ends.size() - 1;
  if (ends.size() <= max_ends) {
    figure.layers.push_back(
        dot_layer("ends", "ends of the local manifold and of " + counted(images, "image", "images"), ends, 1.2));
    figure.layers.back().hollow = true;
  }
  figure.layers.push_back(
      dot_layer("saddle", "saddle, multiplier " + rounded(manifold.local.multiplier), {manifold.local.saddle}, 1.8));
  figure.layers.back().shape = DotShape::square;
  if (!how.labels_for(ends.size()) || ends.size() > 8 * max_named_ends) return figure;
  figure.labels.push_back({.text = "p", .at = manifold.local.saddle, .radius = 2.2, .size = 8});
  for (std::size_t k = ends.size(); k-- > 0;) {  // those of late images lie apart
    figure.labels.push_back({.text = std::to_string(k), .at = ends[k], .radius = 1.6, .size = 6.5});
  }
  return figure;
}

}  // namespace lober::cli
