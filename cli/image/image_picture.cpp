// The picture of a curve with its images and pre-images.

#include <cmath>
#include <cstdlib>

#include "cli/image/image_report.hpp"
#include "cli/picture/system_figure.hpp"

namespace lober::cli {
namespace {

const char* iterate_colour(int iterate) {
  return iterate < 0 ? palette::stable : iterate > 0 ? palette::unstable : palette::ink;
}

// The nearer to the curve, the wider.
double iterate_width(int iterate) {
  return iterate == 0 ? 1.0 : std::max(0.3, 0.7 - 0.12 * (std::abs(iterate) - 1));
}

// "f^{-2}" for a name that may have words behind it.
std::string power_text(int iterate, const char* of) {
  if (iterate == 0) return of;
  std::string text = "f";
  if (iterate != 1) text += "^{" + std::string(iterate < 0 ? "\u2212" : "") + std::to_string(std::abs(iterate)) + "}";
  return text + "(" + of + ")";
}

// B, or of two boundaries B_1 and B_2.
const char* curve_name(const operations::CurveImages& found, std::size_t curve) {
  return found.bips.size() < 2 ? "B" : curve == 0 ? "B_{1}" : "B_{2}";
}

// The bip of a boundary and its images, which are the bips of the boundary's images.
void add_bips(Figure& figure, const ImageReport& report) {
  const operations::CurveImages& found = report.found();
  if (found.bips.empty()) return;
  Layer dots = dot_layer("bips", "bip q and its images", {}, 1.8);
  dots.hollow = true;
  for (const auto& one : found.images) {
    Point at = found.bips[std::min(one.curve, found.bips.size() - 1)];
    report.system.system->map->iterate(std::span<Point>(&at, 1), one.image.iterate);
    if (!std::isfinite(at.x + at.y)) continue;
    dots.points.push_back(at);
    const bool several = found.bips.size() > 1;
    figure.labels.push_back({.text = power_text(one.image.iterate, !several         ? "q"
                                                                   : one.curve == 0 ? "q_{1}"
                                                                                    : "q_{2}"),
                             .at = at,
                             .radius = 2.2,
                             .size = 7});
  }
  figure.layers.push_back(std::move(dots));
}

// The names of the images, each where it reaches farthest beyond those that are nearer to the curve.
void add_names(Figure& figure, const operations::CurveImages& found) {
  constexpr int max_named_images = 12;
  if (found.images.size() > max_named_images) return;
  for (const auto& one : found.images) {
    Rectangle nearer;
    for (const auto& other : found.images) {
      if (std::abs(other.image.iterate) >= std::abs(one.image.iterate) || other.curve != one.curve) continue;
      for (const ImagePart& part : other.parts) nearer = include(nearer, part.points);
    }
    const Rectangle& window = figure.window;
    double farthest = 0;
    Point at{};
    for (const ImagePart& part : one.parts) {
      for (const Point& point : part.points) {
        if (nearer.empty() || !window.contains(point)) continue;
        const double beyond =
            std::max({(point.x - nearer.max_x) / window.width(), (nearer.min_x - point.x) / window.width(),
                      (point.y - nearer.max_y) / window.height(), (nearer.min_y - point.y) / window.height()});
        if (beyond <= farthest) continue;
        farthest = beyond;
        at = point;
      }
    }
    if (farthest > 0.01) {
      figure.labels.push_back(
          {.text = power_text(one.image.iterate, curve_name(found, one.curve)), .at = at, .radius = 0.5, .size = 7});
    }
  }
}

}  // namespace

Figure image_figure(const ImageReport& report) {
  // The window has the parts in the box, where the curves meet the tolerance.
  const operations::CurveImages& found = report.found();
  const Rectangle& box = found.box;
  Rectangle window;
  for (const auto& one : found.images) {
    for (const ImagePart& part : one.parts) {
      for (const Point& point : part.points) {
        if (box.contains(point)) window.add(point);
      }
    }
  }
  Figure figure{.what = "A curve, its images and pre-images", .title = system_title(report.system.system->info)};
  name_axes(figure, *report.system.system);
  figure.window = with_margin(window.empty() ? box : window);
  // The outermost first, so that the curve itself is on top.
  int furthest = 0;
  for (const auto& one : found.images) furthest = std::max(furthest, std::abs(one.image.iterate));
  for (int distance = furthest; distance >= 0; --distance) {
    for (const auto& one : found.images) {
      const int iterate = one.image.iterate;
      if (std::abs(iterate) != distance) continue;
      std::string text = power_text(iterate, curve_name(found, one.curve)) + ": " +
                         std::to_string(one.image.points.size()) + " points";
      if (one.parts.size() > 1) text += " in " + std::to_string(one.parts.size()) + " parts";
      Layer layer = line_layer(one.name(), text, iterate_colour(iterate), iterate_width(iterate));
      for (const ImagePart& part : one.parts) layer.lines.push_back(polyline(part.points, part.closed));
      figure.layers.push_back(std::move(layer));
    }
  }
  add_bips(figure, report);
  add_names(figure, found);
  figure.notes.push_back(found.bips.empty()       ? "B: " + report.curve()
                         : found.bips.size() == 1 ? "B: boundary with the bip q"
                                                  : "B_{1}, B_{2}: boundaries with the bips q_{1}, q_{2}");
  return figure;
}

}  // namespace lober::cli
