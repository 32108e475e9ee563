#include "cli/report/svg.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "cli/report/text.hpp"
#include "lober/curve/drawing.hpp"

namespace lober::cli {
namespace {

constexpr double legend_line = 24;

// The frame of the plot with its margins.
struct Frame {
  double left, right, top, bottom;
};

// Cuts the segment down to the frame (Liang & Barsky, ACM Trans. Graph. 3, 1984); false if nothing is left.
bool clip(Pixel& a, Pixel& b, const Frame& frame) {
  const Pixel from = a, step{b.x - a.x, b.y - a.y};
  double first = 0, last = 1;
  const auto keep = [&](double speed, double limit) {  // speed t <= limit
    if (speed == 0) return limit >= 0;
    (speed < 0 ? first : last) = speed < 0 ? std::max(first, limit / speed) : std::min(last, limit / speed);
    return first <= last;
  };
  if (!keep(-step.x, from.x - frame.left) || !keep(step.x, frame.right - from.x)) return false;
  if (!keep(-step.y, from.y - frame.top) || !keep(step.y, frame.bottom - from.y)) return false;
  if (first > 0) a = {from.x + first * step.x, from.y + first * step.y};
  if (last < 1) b = {from.x + last * step.x, from.y + last * step.y};
  return true;
}

// The part of a polygon in the frame, with sides along it where the polygon leaves it (Sutherland & Hodgman, Commun.
// ACM 17, 1974).
std::vector<Pixel> clip_polygon(std::vector<Pixel> polygon, const Frame& frame) {
  const auto cut = [&](double Pixel::*axis, double limit, double sign) {
    std::vector<Pixel> kept;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Pixel a = polygon[k], b = polygon[k + 1 < polygon.size() ? k + 1 : 0];
      const bool a_in = sign * (a.*axis - limit) <= 0, b_in = sign * (b.*axis - limit) <= 0;
      if (a_in) kept.push_back(a);
      if (a_in == b_in) continue;
      const double t = (limit - a.*axis) / (b.*axis - a.*axis);
      kept.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
    }
    polygon = std::move(kept);
  };
  cut(&Pixel::x, frame.left, -1);
  cut(&Pixel::x, frame.right, 1);
  cut(&Pixel::y, frame.top, -1);
  cut(&Pixel::y, frame.bottom, 1);
  return polygon;
}

}  // namespace

int subpixel(double pixels) {
  return static_cast<int>(std::lround(pixels * subpixels));
}

Rectangle include(const Rectangle& box, std::span<const Point> points) {
  Rectangle result = box;
  for (const Point& point : points) result.add(point);
  return result;
}

View::View(const Rectangle& window) : low_{window.min_x, window.min_y} {
  // Halves, because a difference of two finite numbers need not be finite.
  half_ = {0.5 * window.max_x - 0.5 * low_.x, 0.5 * window.max_y - 0.5 * low_.y};
  const detail::PictureSize size = detail::picture_size(window);
  height_ = size.height;
  plot_width_ = size.width;
}

double View::left() const {
  return picture_margin + 0.5 * (picture_width - plot_width_);
}

Pixel View::operator()(Point p) const {
  const auto fraction = [](double value, double low, double half) {
    constexpr double far = 1e6;  // windows away; what is drawn lies inside
    return half > 0 ? std::clamp((0.5 * value - 0.5 * low) / half, -far, far) : 0.5;
  };
  return {left() + plot_width_ * fraction(p.x, low_.x, half_.x),
          picture_margin + height_ * (1 - fraction(p.y, low_.y, half_.y))};
}

void PathWriter::add_polygon(std::span<const Point> polygon) {
  if (full_) return;
  std::vector<Pixel> line;
  line.reserve(polygon.size());
  // Sides along the frame lie far enough outside not to be seen.
  const double beyond = 200;
  const Frame frame{-beyond, picture_width + 2 * picture_margin + beyond, -beyond,
                    view_.height() + 2 * picture_margin + beyond};
  bool leaves = false;
  for (const Point& point : polygon) {
    const Pixel at = view_(point);
    leaves = leaves || at.x < frame.left || at.x > frame.right || at.y < frame.top || at.y > frame.bottom;
    line.push_back(at);
  }
  if (leaves) line = clip_polygon(std::move(line), frame);
  const std::vector<Pixel> drawn = simplified_line(line, tolerance_);
  if (drawn.size() >= 3) draw(drawn, true);
}

void PathWriter::add_line(std::span<const Point> line) {
  const Frame frame{0, picture_width + 2 * picture_margin, 0, view_.height() + 2 * picture_margin};
  Coverage coverage(frame.right, frame.bottom, std::max(0.5, tolerance_));
  std::vector<Pixel> part;
  const auto finish = [&] {
    const std::vector<Pixel> kept = simplified_line(part, tolerance_);
    part.clear();
    std::size_t first = 0;
    for (std::size_t k = 0; k + 1 < kept.size(); ++k) {
      if (coverage.mark(kept[k], kept[k + 1])) continue;
      draw(std::span(kept).subspan(first, k + 1 - first), false);
      first = k + 1;
    }
    draw(std::span(kept).subspan(first), false);
  };
  for (std::size_t k = 0; k + 1 < line.size() && !full_; ++k) {
    Pixel a = view_(line[k]), b = view_(line[k + 1]);
    const Pixel end = b;
    if (!clip(a, b, frame)) {
      finish();
      continue;
    }
    if (part.empty()) part.push_back(a);
    part.push_back(b);
    if (b.x != end.x || b.y != end.y) finish();
  }
  finish();
}

void PathWriter::draw(std::span<const Pixel> line, bool closed) {
  if (full_ || line.size() < 2) return;
  full_ = line.size() > points_left_;
  if (full_) return;
  points_left_ -= line.size();
  int x = subpixel(line[0].x), y = subpixel(line[0].y);
  append_all(path_, "M", x, " ", y, "l");
  for (std::size_t k = 1; k < line.size(); ++k) {
    const int next_x = subpixel(line[k].x), next_y = subpixel(line[k].y);
    const int step_x = next_x - x, step_y = next_y - y;
    append_all(path_, k > 1 && step_x >= 0 ? " " : "", step_x, step_y >= 0 ? " " : "", step_y);
    x = next_x;
    y = next_y;
  }
  if (closed) path_ += "z";
}

std::string polygon_path(const View& view, std::span<const Point> polygon, std::size_t max_points) {
  return path_of(view, max_points, [&](PathWriter& writer) { writer.add_polygon(polygon); });
}

std::string line_path(const View& view, std::span<const Point> line, std::size_t max_points) {
  return path_of(view, max_points, [&](PathWriter& writer) { writer.add_line(line); });
}

void begin_picture(std::string& svg, const View& view, std::string_view title, int legend_lines, bool clipped) {
  const double full_width = picture_width + 2 * picture_margin;
  const double full_height = view.height() + 2 * picture_margin + legend_lines * legend_line + 12;
  append_all(svg, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"", full_width, "\" height=\"", full_height,
             "\" viewBox=\"0 0 ", full_width, " ", full_height, "\">\n", "<title>", escaped(title), "</title>\n",
             "<rect width=\"100%\" height=\"100%\" fill=\"#fbfaf7\"/>\n");
  if (clipped) {
    append_all(svg, "<clipPath id=\"plot\"><rect width=\"", subpixel(full_width), "\" height=\"",
               subpixel(view.height() + 2 * picture_margin - 8), "\"/></clipPath>\n");
  }
  append_all(svg, "<g transform=\"scale(", 1.0 / subpixels, ")\" stroke-linejoin=\"round\"",
             clipped ? " clip-path=\"url(#plot)\"" : "", ">\n");
}

void add_filled(std::string& svg, std::string_view colour, std::string_view rule, const std::string& path) {
  append_all(svg, "<path fill=\"", colour, "\" fill-opacity=\"0.4\" fill-rule=\"", rule, "\" d=\"", path, "\"/>\n");
}

void add_stroked(std::string& svg, std::string_view colour, double pixels, const std::string& path) {
  append_all(svg, "<path fill=\"none\" stroke=\"", colour, "\" stroke-width=\"", pixels * subpixels, "\" d=\"", path,
             "\"/>\n");
}

void add_dot(std::string& svg, Pixel at, double radius) {
  append_all(svg, "<circle cx=\"", subpixel(at.x), "\" cy=\"", subpixel(at.y), "\" r=\"", subpixel(radius), "\"/>\n");
}

void add_arrow_head(std::string& svg, Pixel from, Pixel apex, double length, std::string_view colour) {
  const double far = std::hypot(apex.x - from.x, apex.y - from.y);
  if (!(far > 0)) return;
  const double x = (apex.x - from.x) / far * length, y = (apex.y - from.y) / far * length;
  append_all(svg, "<path fill=\"", colour, "\" d=\"M", subpixel(apex.x), " ", subpixel(apex.y), "L",
             subpixel(apex.x - x - 0.4 * y), " ", subpixel(apex.y - y + 0.4 * x), " ", subpixel(apex.x - x + 0.4 * y),
             " ", subpixel(apex.y - y - 0.4 * x), "z\"/>\n");
}

void begin_legend(std::string& svg) {
  svg += "</g>\n";
}

std::string line_swatch(std::string_view colour, double pixels) {
  std::string swatch;
  append_all(swatch, "<path d=\"M0 0h26\" stroke=\"", colour, "\" stroke-width=\"", pixels, "\"/>");
  return swatch;
}

std::string filled_swatch(std::string_view colour) {
  std::string swatch;
  append_all(swatch, "<rect y=\"-8\" width=\"26\" height=\"16\" fill=\"", colour, "\" fill-opacity=\"0.4\"/>");
  return swatch;
}

std::string opaque_swatch(std::string_view colour) {
  std::string swatch;
  append_all(swatch, "<rect y=\"-8\" width=\"26\" height=\"16\" fill=\"", colour, "\"/>");
  return swatch;
}

void add_legend_entry(std::string& svg, const View& view, int column, int line, std::string_view swatch,
                      std::string_view text) {
  const double x = picture_margin + column * picture_width / 2;
  const double y = view.height() + 2 * picture_margin + 8 + line * legend_line;
  append_all(svg, "<g transform=\"translate(", x, " ", y, ")\">", swatch,
             "<text x=\"34\" y=\"5\" font-family=\"sans-serif\" font-size=\"15\" fill=\"#333333\">", escaped(text),
             "</text></g>\n");
}

void end_picture(std::string& svg) {
  svg += "</svg>\n";
}

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      default:  // XML has no control characters
        result += static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t' ? ' ' : c;
    }
  }
  return result;
}

std::string rounded(double value) {
  std::array<char, 32> buffer;
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 6).ptr;
  return {buffer.data(), end};
}

}  // namespace lober::cli
