// The picture of a curve whose points were inserted or removed.

#include <algorithm>

#include "cli/densify/densify_report.hpp"
#include "cli/picture/system_figure.hpp"
#include "cli/report/report.hpp"

namespace lober::cli {
namespace {

constexpr std::size_t max_large_dots = 60;

std::string criterion_text(DiagnosticCause cause) {
  switch (cause) {
    case DiagnosticCause::min_length:
      return "shorter than --min-length otherwise";
    case DiagnosticCause::corner:
      return "a corner of the interpolation";
    case DiagnosticCause::max_points:
      return "too many points otherwise";
    case DiagnosticCause::max_rounds:
      return "not met after the last round";
  }
  return {};
}

// Points that are not among the others, which come in the same order.
std::vector<Point> points_besides(std::span<const Point> points, std::span<const Point> others) {
  std::vector<Point> rest;
  std::size_t next = 0;
  for (const Point& point : points) {
    if (next < others.size() && point == others[next]) {
      ++next;
    } else {
      rest.push_back(point);
    }
  }
  return rest;
}

Layer criterion_layer(const DensifiedCurve& curve, DiagnosticCause cause) {
  Layer layer = dot_layer(std::string(name(cause)), "", {}, 1.6);
  layer.shape = DotShape::cross;
  layer.colour = palette::common;
  for (const Diagnostic& diagnostic : curve.diagnostics) {
    if (diagnostic.cause == cause) layer.points.push_back(curve.points[diagnostic.first]);
  }
  layer.legend = "criterion not met: " + criterion_text(cause);
  return layer;
}

}  // namespace

Figure densify_figure(const std::vector<NamedCurve>& curves, const operations::RefinedCurve& found) {
  const std::span<const Point> given = curves[0].curve.points, made = found.points;
  Figure figure{.what = "A curve with points inserted or removed", .title = short_name(spec_of(curves[0]))};
  name_axes(figure, curves[0]);
  figure.window = with_margin(include(include({}, given), made));
  if (curves.size() > 1) {
    figure.layers.push_back(line_layer("AGAINST", "against " + short_name(spec_of(curves[1])), palette::curve2, 0.5));
    figure.layers.back().lines.push_back(
        polyline(std::span<const Point>(curves[1].curve.points), curves[1].curve.closed, "AGAINST"));
  }
  figure.layers.push_back(
      line_layer("curve", "the curve, " + counted(made.size(), "point", "points"), palette::curve1, 0.5));
  figure.layers.back().lines.push_back(polyline(made, found.closed, "curve"));
  const double radius = std::max(given.size(), made.size()) > max_large_dots ? 0.8 : 1.2;
  const auto dots = [&](const char* layer, const char* one, const char* many, std::vector<Point> points, bool hollow) {
    if (points.empty()) return;
    const std::string text = counted(points.size(), one, many);
    figure.layers.push_back(dot_layer(layer, text, std::move(points), radius));
    figure.layers.back().hollow = hollow;
    figure.layers.back().colour = hollow ? palette::ink : palette::curve1;
  };
  // Which of the points were there before is known where points were only inserted or only removed.
  std::vector<Point> inserted = points_besides(made, given), removed = points_besides(given, made);
  const bool only_inserted = inserted.size() + given.size() == made.size();
  const bool only_removed = removed.size() + made.size() == given.size();
  dots("given", "point given", "points given", {given.begin(), given.end()}, true);
  if (only_inserted) {
    dots("inserted", "point inserted", "points inserted", std::move(inserted), false);
  } else {
    dots(only_removed ? "kept" : "result", only_removed ? "point kept" : "point of the result",
         only_removed ? "points kept" : "points of the result", {made.begin(), made.end()}, false);
  }
  for (const DiagnosticCause cause : all_diagnostic_causes) {
    const bool occurs = std::any_of(found.diagnostics.begin(), found.diagnostics.end(),
                                    [&](const Diagnostic& one) { return one.cause == cause; });
    if (occurs) figure.layers.push_back(criterion_layer(found, cause));
  }
  return figure;
}

}  // namespace lober::cli
