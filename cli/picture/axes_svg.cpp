#include "cli/picture/axes_svg.hpp"

#include <algorithm>

#include "cli/picture/rich_text.hpp"
#include "cli/report/text.hpp"

namespace lober::cli {
namespace {

constexpr double tick_length = 2.4;

// With at most `max_count` + 1 ticks, or one for each category.
Ticks ticks_of(double low, double high, int max_count, const Axis& axis) {
  if (axis.categories.empty()) {
    Ticks ticks = ticks_between(low, high, max_count, axis.whole_numbers || axis.exponents);
    if (axis.exponents) {
      for (Tick& tick : ticks.list) tick.text = "10^{" + tick.text + "}";
    }
    return ticks;
  }
  Ticks ticks;
  for (std::size_t k = 0; k < axis.categories.size(); ++k) {
    const double fraction = (static_cast<double>(k) - low) / (high - low);
    if (fraction >= 0 && fraction <= 1) ticks.list.push_back({fraction, axis.categories[k]});
  }
  return ticks;
}

}  // namespace

std::string axis_text(const Axis& axis, const Ticks& ticks) {
  std::string text = axis.name;
  if (!ticks.offset.empty()) text += " " + ticks.offset;
  std::string unit = axis.unit;
  if (ticks.power != 0) {
    std::string power = std::to_string(ticks.power);
    if (ticks.power < 0) power = "\u2212" + power.substr(1);
    unit = "10^{" + power + "}" + (unit.empty() ? "" : " " + unit);
  }
  return unit.empty() ? text : text + " (" + unit + ")";
}

double widest(const Ticks& ticks, double font_size) {
  double width = 0;
  for (const Tick& tick : ticks.list) width = std::max(width, text_width(tick.text, font_size));
  return width;
}

Ticks ticks_across(const Rectangle& window, double width, double font_size, const Axis& axis) {
  for (int count = 8;; --count) {
    Ticks ticks = ticks_of(window.min_x, window.max_x, count, axis);
    const auto texts = static_cast<double>(ticks.list.size());
    const double step = ticks.list.size() > 1 ? (ticks.list[1].fraction - ticks.list[0].fraction) * width : width;
    if (count <= 1 || texts <= 1 || step >= widest(ticks, font_size) + font_size) return ticks;
  }
}

Ticks ticks_up(const Rectangle& window, double height, double font_size, const Axis& axis) {
  const int count = std::clamp(static_cast<int>(height / (2.6 * font_size)), 1, 8);
  return ticks_of(window.min_y, window.max_y, count, axis);
}

void add_axes(std::string& svg, const View& view, const Ticks& across, const Ticks& up, double font_size) {
  const Frame& frame = view.frame();
  std::string path;
  append_all(path, "M", hundredth(frame.x), " ", hundredth(frame.y), "h", hundredth(frame.width), "v",
             hundredth(frame.height), "h", hundredth(-frame.width), "z");
  for (const Tick& tick : across.list) {
    append_all(path, "M", hundredth(frame.x + tick.fraction * frame.width), " ", hundredth(frame.bottom()), "v",
               tick_length);
  }
  for (const Tick& tick : up.list) {
    append_all(path, "M", hundredth(frame.x), " ", hundredth(frame.bottom() - tick.fraction * frame.height), "h",
               -tick_length);
  }
  append_all(svg, "<path fill=\"none\" stroke=\"#222222\" stroke-width=\"0.5\" d=\"", path, "\"/>\n");
  for (const Tick& tick : across.list) {
    add_text(svg, frame.x + tick.fraction * frame.width, frame.bottom() + tick_length + 0.95 * font_size, tick.text,
             {.size = font_size, .anchor = "middle"});
  }
  for (const Tick& tick : up.list) {
    add_text(svg, frame.x - tick_length - 1.2, frame.bottom() - tick.fraction * frame.height + 0.36 * font_size,
             tick.text, {.size = font_size, .anchor = "end"});
  }
}

}  // namespace lober::cli
