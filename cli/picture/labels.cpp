#include "cli/picture/labels.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "cli/picture/rich_text.hpp"
#include "cli/report/text.hpp"

namespace lober::cli {
namespace {

constexpr double layout_scale = 4;     // the layout is made for pictures of a thousand pixels
constexpr double leader_distance = 5;  // between dot and label, from which a line leads from one to the other
constexpr double line_height = 1.05;

}  // namespace

Labels::Labels(const View& view)
    : frame_(view.frame()), layout_(layout_scale * frame_.width, layout_scale * frame_.height) {}

Point Labels::in_layout(PrintPoint at) const {
  return {layout_scale * (at.x - frame_.x), layout_scale * (at.y - frame_.y)};
}

std::vector<Point> Labels::in_layout(std::span<const PrintPoint> line) const {
  std::vector<Point> moved;
  for (const PrintPoint& at : line) moved.push_back(in_layout(at));
  return moved;
}

void Labels::avoid_line(std::span<const PrintPoint> line) {
  for (std::size_t k = 0; k + 1 < line.size(); ++k) layout_.add_line(in_layout(line[k]), in_layout(line[k + 1]));
}

void Labels::avoid_dot(PrintPoint dot, double radius) {
  const Point at = in_layout(dot);
  const double reach = layout_scale * radius;
  layout_.block({at.x - reach, at.y - reach, at.x + reach, at.y + reach});
}

void Labels::avoid_frame(const Frame& frame) {
  const Point low = in_layout({frame.x, frame.y}), high = in_layout({frame.right(), frame.bottom()});
  layout_.block({low.x, low.y, high.x, high.y});
}

void Labels::draw(const Rectangle& box, PrintPoint at, double radius, std::string_view text, double size) {
  const auto in_picture = [&](double x, double y) {
    return PrintPoint{frame_.x + x / layout_scale, frame_.y + y / layout_scale};
  };
  const PrintPoint low = in_picture(box.min_x, box.min_y), high = in_picture(box.max_x, box.max_y);
  const PrintPoint nearest{std::clamp(at.x, low.x, high.x), std::clamp(at.y, low.y, high.y)};
  const double distance = std::hypot(nearest.x - at.x, nearest.y - at.y);
  if (distance > radius + leader_distance) {
    const double begin = (radius + 0.5) / distance;
    const double end = 1 - begin;
    append_all(svg_, "<path d=\"M", hundredth(at.x + begin * (nearest.x - at.x)), " ",
               hundredth(at.y + begin * (nearest.y - at.y)), "l", hundredth(end * (nearest.x - at.x)), " ",
               hundredth(end * (nearest.y - at.y)), "\" stroke=\"#666666\" stroke-width=\"0.35\"/>\n");
  }
  add_text(svg_, 0.5 * (low.x + high.x), 0.5 * (low.y + high.y) + 0.35 * size, text,
           {.size = size, .anchor = "middle", .halo = true});
}

void Labels::add_beside(PrintPoint dot, double radius, std::string_view text, double size) {
  const auto box = layout_.put_beside(in_layout(dot), layout_scale * radius, layout_scale * text_width(text, size),
                                      layout_scale * line_height * size);
  if (box) draw(*box, dot, radius, text, size);
}

void Labels::put_where_roomiest(std::span<const Point> outline, std::string_view text, double size) {
  const double width = layout_scale * text_width(text, size), height = layout_scale * line_height * size;
  const auto found = layout_.roomiest(outline, width / height);
  if (!found) return;
  const auto box = layout_.put_about(found->at, width, height);
  const PrintPoint at{frame_.x + found->at.x / layout_scale, frame_.y + found->at.y / layout_scale};
  if (box) draw(*box, at, 0, text, size);
}

void Labels::add_inside(std::span<const PrintPoint> polygon, std::string_view text, double size) {
  put_where_roomiest(in_layout(polygon), text, size);
}

void Labels::add_outside(std::span<const PrintPoint> polygon, std::string_view text, double size) {
  // The frame, with the polygon as a hole: a seam leads from one to the other and back.
  const double right = layout_scale * frame_.width, bottom = layout_scale * frame_.height;
  std::vector<Point> outline{{0, 0}, {right, 0}, {right, bottom}, {0, bottom}, {0, 0}};
  const std::vector<Point> hole = in_layout(polygon);
  outline.insert(outline.end(), hole.begin(), hole.end());
  if (!hole.empty()) outline.push_back(hole.front());
  put_where_roomiest(outline, text, size);
}

}  // namespace lober::cli
