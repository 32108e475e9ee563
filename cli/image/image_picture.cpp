// The picture of a curve with its images and pre-images.

#include <cmath>
#include <cstdlib>

#include "cli/image/image_report.hpp"
#include "cli/report/palette.hpp"
#include "cli/report/svg.hpp"

namespace lober::cli {
namespace {

const char* iterate_colour(int iterate) {
  return iterate < 0 ? palette::stable : iterate > 0 ? palette::unstable : "#222222";
}

// The nearer to the curve, the wider.
double iterate_width(int iterate) {
  return iterate == 0 ? 2.2 : std::max(0.5, 1.6 - 0.3 * (std::abs(iterate) - 1));
}

std::string parts_path(const View& view, const std::vector<ImagePart>& parts) {
  return path_of(view, max_path_points, [&](PathWriter& writer) {
    for (const ImagePart& part : parts) {
      std::vector<Point> line(part.points.begin(), part.points.end());
      if (part.closed) line.push_back(line.front());
      writer.add_line(line);
    }
  });
}

}  // namespace

void write_image_picture(const std::string& path, const ImageReport& report, const std::optional<Rectangle>& given) {
  // The parts in the box, where the curves meet the tolerance.
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
  if (given) window = *given;
  if (window.empty()) window = box;
  const View view(window);
  std::string svg;
  begin_picture(svg, view, "A curve, its images and pre-images", static_cast<int>(1 + (found.images.size() + 1) / 2),
                given.has_value());
  // The outermost first, so that the curve itself is on top.
  int furthest = 0;
  for (const auto& one : found.images) furthest = std::max(furthest, std::abs(one.image.iterate));
  for (int distance = furthest; distance >= 0; --distance) {
    for (const auto& one : found.images) {
      const int iterate = one.image.iterate;
      if (std::abs(iterate) != distance) continue;
      add_stroked(svg, iterate_colour(iterate), iterate_width(iterate), parts_path(view, one.parts));
    }
  }
  begin_legend(svg);
  add_legend_entry(svg, view, 0, 0, line_swatch(iterate_colour(0), iterate_width(0)), report.curve());
  for (std::size_t k = 0; k < found.images.size(); ++k) {
    const auto& one = found.images[k];
    const int iterate = one.image.iterate;
    std::string text = one.name() + ": " + std::to_string(one.image.points.size()) + " points";
    if (one.parts.size() > 1) text += " in " + std::to_string(one.parts.size()) + " parts";
    add_legend_entry(svg, view, static_cast<int>(k % 2), static_cast<int>(1 + k / 2),
                     line_swatch(iterate_colour(iterate), iterate_width(iterate)), text);
  }
  end_picture(svg);
  write_file(path, svg);
}

}  // namespace lober::cli
