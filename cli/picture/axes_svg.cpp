#include "cli/picture/axes_svg.hpp"

#include <algorithm>
#include <array>

#include "cli/picture/rich_text.hpp"
#include "cli/report/text.hpp"

namespace lober::cli {
namespace {

constexpr double tick_length = 2.4;
constexpr std::size_t max_category_letters = 18;

std::string shortened_category(const std::string& name) {
  if (name.size() <= max_category_letters) return name;
  std::size_t begin = name.size() - max_category_letters + 1;
  while (begin < name.size() && (static_cast<unsigned char>(name[begin]) & 0xC0U) == 0x80U) ++begin;
  return "\u2026" + name.substr(begin);  // names of files differ at their ends
}

// Every n-th name, n = 1, 2, 5, 10, ... as small as can be, of those between low and high, so that there is room for
// them.
template <typename Fits>
Ticks category_ticks(double low, double high, const std::vector<std::string>& names, const Fits& fits) {
  constexpr std::array<std::size_t, 3> factors{1, 2, 5};
  for (std::size_t step = 0;; ++step) {
    std::size_t every = factors[step % factors.size()];
    for (std::size_t k = 0; k < step / factors.size(); ++k) every *= 10;
    Ticks ticks;
    for (std::size_t k = 0; k < names.size(); k += every) {
      const auto at = static_cast<double>(k);
      if (at >= low && at <= high) ticks.list.push_back({(at - low) / (high - low), shortened_category(names[k])});
    }
    if (every >= names.size() || ticks.list.size() < 2 || fits(ticks)) return ticks;
  }
}

// With at most `max_count` + 1 ticks.
Ticks ticks_of(double low, double high, int max_count, const Axis& axis) {
  Ticks ticks = ticks_between(low, high, max_count, axis.whole_numbers || axis.exponents);
  if (axis.exponents) {
    for (Tick& tick : ticks.list) tick.text = "10^{" + tick.text + "}";
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
    unit = "10^{" + power + "}" + (unit.empty() ? "" : "\u00a0" + unit);
  }
  return unit.empty() ? text : text + " (" + unit + ")";
}

double widest(const Ticks& ticks, double font_size) {
  double width = 0;
  for (const Tick& tick : ticks.list) width = std::max(width, text_width(tick.text, font_size));
  return width;
}

Ticks ticks_across(const Rectangle& window, double width, double font_size, const Axis& axis) {
  const auto spacing = [&](const Ticks& ticks) { return (ticks.list[1].fraction - ticks.list[0].fraction) * width; };
  const auto fits = [&](const Ticks& ticks) { return spacing(ticks) >= widest(ticks, font_size) + font_size; };
  if (!axis.categories.empty()) return category_ticks(window.min_x, window.max_x, axis.categories, fits);
  for (int count = 8;; --count) {
    Ticks ticks = ticks_of(window.min_x, window.max_x, count, axis);
    if (count <= 1 || ticks.list.size() <= 1 || fits(ticks)) return ticks;
  }
}

Ticks ticks_up(const Rectangle& window, double height, double font_size, const Axis& axis) {
  if (!axis.categories.empty()) {
    return category_ticks(window.min_y, window.max_y, axis.categories, [&](const Ticks& ticks) {
      return (ticks.list[1].fraction - ticks.list[0].fraction) * height >= 1.3 * font_size;
    });
  }
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
