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

// "f^{-2}" of "f^-2".
std::string printed_name(const std::string& name) {
  const std::size_t power = name.find('^') + 1, end = std::min(name.find(' ', power), name.size());
  if (power == 0) return name;
  std::string digits = name.substr(power, end - power);
  if (digits.starts_with('-')) digits.replace(0, 1, "\u2212");
  return name.substr(0, power) + "{" + digits + "}" + name.substr(end);
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
        if (point.x >= box.min_x && point.x <= box.max_x && point.y >= box.min_y && point.y <= box.max_y) {
          window.add(point);
        }
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
      std::string text = printed_name(one.name()) + ": " + std::to_string(one.image.points.size()) + " points";
      if (one.parts.size() > 1) text += " in " + std::to_string(one.parts.size()) + " parts";
      Layer layer = line_layer(one.name(), text, iterate_colour(iterate), iterate_width(iterate));
      for (const ImagePart& part : one.parts) layer.lines.push_back(polyline(part.points, part.closed));
      figure.layers.push_back(std::move(layer));
    }
  }
  figure.notes.push_back("curve: " + report.curve());
  return figure;
}

}  // namespace lober::cli
