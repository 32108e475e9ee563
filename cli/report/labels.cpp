#include "cli/report/labels.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "cli/report/text.hpp"

namespace lober::cli {
namespace {

constexpr double script_scale = 0.72;   // size of subscripts
constexpr double leader_distance = 16;  // pixels between dot and label from which a line leads from one to the other

struct Run {
  std::string text;
  int shift = 0;  // -1: below the line, +1: above
};

std::vector<Run> runs_of(std::string_view text) {
  std::vector<Run> runs{{}};
  for (std::size_t k = 0; k < text.size(); ++k) {
    const bool script = (text[k] == '_' || text[k] == '^') && k + 1 < text.size() && text[k + 1] == '{';
    if (!script) {
      runs.back().text += text[k];
      continue;
    }
    const std::size_t end = text.find('}', k);
    runs.push_back({std::string(text.substr(k + 2, end - k - 2)), text[k] == '_' ? -1 : 1});
    runs.push_back({});
    k = end;
  }
  return runs;
}

// Width of text in a sans-serif font, generously.
double text_width(std::span<const Run> runs, double size) {
  double width = 0;
  for (const Run& run : runs) {
    const double letters = static_cast<double>(std::count_if(
        run.text.begin(), run.text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
    width += letters * size * 0.62 * (run.shift == 0 ? 1 : script_scale);
  }
  return width;
}

double tenth(double value) {
  return std::round(10 * value) / 10;
}

}  // namespace

Labels::Labels(const View& view)
    : view_(view), layout_(picture_width + 2 * picture_margin, view.height() + 2 * picture_margin) {}

void Labels::avoid(std::span<const Point> line) {
  for (std::size_t k = 0; k + 1 < line.size(); ++k) layout_.add_line(view_(line[k]), view_(line[k + 1]));
}

void Labels::avoid(Pixel dot, double radius) {
  layout_.block({dot.x - radius, dot.y - radius, dot.x + radius, dot.y + radius});
}

void Labels::draw(const Rectangle& box, Pixel at, double radius, std::string_view text, double size) {
  const Pixel nearest{std::clamp(at.x, box.min_x, box.max_x), std::clamp(at.y, box.min_y, box.max_y)};
  const double distance = std::hypot(nearest.x - at.x, nearest.y - at.y);
  if (distance > radius + leader_distance) {
    const double begin = (radius + 2) / distance;
    append_all(svg_, "<path d=\"M", tenth(at.x + begin * (nearest.x - at.x)), " ",
               tenth(at.y + begin * (nearest.y - at.y)), "L", tenth(nearest.x), " ", tenth(nearest.y),
               "\" stroke=\"#8a877f\" stroke-width=\"1\"/>\n");
  }
  const std::vector<Run> runs = runs_of(text);
  append_all(svg_, "<text x=\"", tenth(0.5 * (box.min_x + box.max_x)), "\" y=\"",
             tenth(0.5 * (box.min_y + box.max_y) + 0.35 * size),
             "\" text-anchor=\"middle\" font-family=\"sans-serif\" font-size=\"", size,
             "\" fill=\"#222222\" stroke=\"#fbfaf7\" stroke-width=\"3\" stroke-linejoin=\"round\" "
             "paint-order=\"stroke\">");
  double level = 0;
  for (const Run& run : runs) {
    if (run.text.empty()) continue;
    const double wanted = run.shift < 0 ? 0.25 * size : run.shift > 0 ? -0.38 * size : 0;
    if (run.shift == 0 && wanted == level) {
      svg_ += escaped(run.text);
      continue;
    }
    append_all(svg_, "<tspan dy=\"", tenth(wanted - level), "\"");
    if (run.shift != 0) append_all(svg_, " font-size=\"", tenth(script_scale * size), "\"");
    append_all(svg_, ">", escaped(run.text), "</tspan>");
    level = wanted;
  }
  svg_ += "</text>\n";
}

void Labels::add_beside(Pixel dot, double radius, std::string_view text, double size) {
  const auto box = layout_.put_beside(dot, radius, text_width(runs_of(text), size), 1.1 * size);
  if (box) draw(*box, dot, radius, text, size);
}

void Labels::add_inside(std::span<const Point> polygon, std::string_view text, double size) {
  std::vector<Point> outline;
  for (const Point& point : polygon) outline.push_back(view_(point));
  const double width = text_width(runs_of(text), size), height = 1.1 * size;
  const auto found = layout_.roomiest(outline, width / height);
  if (!found) return;
  if (const auto box = layout_.put_about(found->at, width, height)) draw(*box, found->at, 0, text, size);
}

void Labels::add_outside(std::span<const Point> polygon, std::string_view text, double size) {
  // The frame, with the polygon as a hole: a seam leads from one to the other and back.
  const double right = picture_width + 2 * picture_margin, bottom = view_.height() + 2 * picture_margin;
  std::vector<Point> outline{{0, 0}, {right, 0}, {right, bottom}, {0, bottom}, {0, 0}};
  for (const Point& point : polygon) outline.push_back(view_(point));
  if (!polygon.empty()) outline.push_back(view_(polygon.front()));
  const double width = text_width(runs_of(text), size), height = 1.1 * size;
  const auto found = layout_.roomiest(outline, width / height);
  if (!found) return;
  if (const auto box = layout_.put_about(found->at, width, height)) draw(*box, found->at, 0, text, size);
}

}  // namespace lober::cli
