#include "cli/picture/figure_svg.hpp"

#include <algorithm>
#include <cmath>

#include "cli/picture/axes_svg.hpp"
#include "cli/picture/inset.hpp"
#include "cli/picture/layers_svg.hpp"
#include "cli/picture/legend.hpp"
#include "cli/picture/rich_text.hpp"
#include "cli/program/log.hpp"
#include "cli/report/text.hpp"

namespace lober::cli {
namespace {

constexpr double points_in_mm = 72 / 25.4;
constexpr double picture_border = 3, title_size = 8, title_step = 9.6, name_size = 8, tick_size = 7;
constexpr std::size_t max_title_lines = 4, max_name_lines = 2;

// The name of an axis, with its unit. One that is longer than the axis is set smaller, then broken, then cut.
struct AxisName {
  std::string text;
  std::vector<std::string> lines;
  double size = name_size;

  AxisName() = default;
  AxisName(std::string all, double length) : text(std::move(all)) {
    const double fitting = name_size * length / std::max(1.0, text_width(text, name_size));
    size = std::clamp(fitting, min_text_size, name_size);
    lines = fitting >= min_text_size ? std::vector{text} : wrapped(text, size, length, max_name_lines);
  }
  [[nodiscard]] double step() const { return 1.15 * size; }
  // The height of the lines behind the first one.
  [[nodiscard]] double further_height() const {
    return lines.size() > 1 ? static_cast<double>(lines.size() - 1) * step() : 0;
  }
};

// Where everything stands. Ticks depend on the size of the plot and the plot on the texts of the ticks: two rounds do.
struct Layout {
  double width, height;
  std::vector<std::string> title;
  Frame plot;
  Ticks across, up;
  AxisName x_name, y_name;
  double legend_top;
};

Layout layout_of(const Figure& figure, const FigureStyle& style, const Rectangle& window, double legend_height) {
  Layout layout;
  layout.width = style.width * points_in_mm;
  layout.title =
      wrapped(style.title.value_or(figure.title), title_size, layout.width - 2 * picture_border, max_title_lines);
  const double top = picture_border + static_cast<double>(layout.title.size()) * title_step + 2;
  double below_plot = 4, below = 0;  // heights: the axis with its texts, and everything
  double left = picture_border + (figure.axes ? name_size + 18 : 0);
  for (int round = 0; round < 3; ++round) {
    if (figure.axes) below_plot = 4 + tick_size + 3 + name_size + layout.x_name.further_height() + 2;
    below = below_plot + (legend_height > 0 ? legend_height + 3 : 0) + picture_border;
    const double right = picture_border + (figure.axes ? std::max(3.0, 0.5 * widest(layout.across, tick_size)) : 0);
    Frame room{left, top, std::max(20.0, layout.width - left - right), 0};
    if (style.height) {
      room.height = std::max(20.0, *style.height * points_in_mm - top - below);
    } else {
      room.height = room.width * (figure.plane ? 1.25 : 0.66);
    }
    layout.plot = figure.plane ? fitted_frame(window, room) : room;
    if (figure.plane && !style.height && layout.plot.height == room.height && layout.plot.width == room.width) {
      layout.plot.height = 0.75 * room.width;  // one scale for both axes does not do
    }
    layout.plot.x += 0.5 * (room.width - layout.plot.width);
    if (!figure.axes) break;
    layout.across = ticks_across(window, layout.plot.width, tick_size, figure.x);
    layout.up = ticks_up(window, layout.plot.height, tick_size, figure.y);
    const double middle = layout.plot.x + 0.5 * layout.plot.width;
    layout.x_name =
        AxisName(axis_text(figure.x, layout.across), 2 * (std::min(middle, layout.width - middle) - picture_border));
    layout.y_name = AxisName(axis_text(figure.y, layout.up), layout.plot.height + 20);
    left = picture_border + layout.y_name.further_height() + name_size + 5 + widest(layout.up, tick_size) + 4;
  }
  layout.legend_top = layout.plot.bottom() + below_plot + 3;
  layout.height = std::max(style.height.value_or(0) * points_in_mm, layout.plot.bottom() + below);
  return layout;
}

// The names of both axes, below the plot and to the left of it.
void add_names(std::string& svg, const Layout& layout) {
  const Frame& plot = layout.plot;
  const auto add = [&](const AxisName& name, double x, double y, bool upward) {
    for (const std::string& line : name.lines) {
      add_text(svg, x, y, line,
               {.size = hundredth(name.size),
                .anchor = "middle",
                .upward = upward,
                .whole = whole_of_cut(name.lines, name.text)});
      (upward ? x : y) += name.step();
    }
  };
  add(layout.x_name, plot.x + 0.5 * plot.width, plot.bottom() + 4 + tick_size + 2 + name_size, false);
  add(layout.y_name, plot.x - 9 - widest(layout.up, tick_size) - layout.y_name.further_height(),
      plot.y + 0.5 * plot.height, true);
}

void add_straight(std::string& svg, PrintPoint a, PrintPoint b, const char* colour, double width) {
  append_all(svg, "<path d=\"M", hundredth(a.x), " ", hundredth(a.y), "L", hundredth(b.x), " ", hundredth(b.y),
             "\" stroke=\"", colour, "\" stroke-width=\"", width, "\"/>\n");
}

void add_guides(std::string& svg, const Figure& figure, const Layout& layout, const View& view) {
  const Frame& plot = layout.plot;
  if (!figure.plane && figure.axes && figure.guides) {
    for (const Tick& tick : layout.up.list) {
      const double y = plot.bottom() - tick.fraction * plot.height;
      add_straight(svg, {plot.x, y}, {plot.right(), y}, palette::grid, 0.35);
    }
  }
  const Rectangle& window = view.window();
  if (figure.zero_line && window.min_y < 0 && window.max_y > 0) {
    const double y = view({window.min_x, 0}).y;
    add_straight(svg, {plot.x, y}, {plot.right(), y}, "#888888", 0.5);
  }
  for (const double mark : figure.x_marks) {
    if (!(mark >= window.min_x && mark <= window.max_x)) continue;
    const double x = view({mark, window.min_y}).x;
    add_straight(svg, {x, plot.y}, {x, plot.bottom()}, "#888888", 0.5);
  }
}

}  // namespace

DrawnFigure draw_figure(const Figure& figure, const FigureStyle& style, const std::string& frame_name) {
  const Rectangle window = drawable_window(style.window ? *style.window : figure.window);
  const double width = style.width * points_in_mm;
  const Figure nothing;
  const Legend legend(style.legend ? figure : nothing, width - 2 * picture_border, style.window ? &window : nullptr);
  const Layout layout = layout_of(figure, style, window, legend.height());
  const View view(window, layout.plot);
  std::string svg;
  for (std::size_t k = 0; k < layout.title.size(); ++k) {
    add_text(svg, 0.5 * layout.width, picture_border + title_size + static_cast<double>(k) * title_step,
             layout.title[k],
             {.size = title_size,
              .anchor = "middle",
              .whole = whole_of_cut(layout.title, style.title.value_or(figure.title))});
  }
  add_guides(svg, figure, layout, view);
  add_layers(svg, figure, view, frame_name.c_str());
  std::optional<Inset> inset;
  if (style.inset) inset.emplace(figure, view, drawable_window(*style.inset));
  const Frame* const taken = inset ? &inset->outer() : nullptr;
  if (inset) inset->draw(svg);
  add_labels(svg, figure, view, taken, 1);
  if (figure.axes) {
    add_axes(svg, view, layout.across, layout.up, tick_size);
    add_names(svg, layout);
  }
  legend.draw(svg, picture_border, layout.legend_top);
  return {std::move(svg), layout.width, layout.height};
}

std::string svg_document(const std::string& title, const DrawnFigure& drawn) {
  std::string svg;
  append_all(svg, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"", hundredth(drawn.width / points_in_mm),
             "mm\" height=\"", hundredth(drawn.height / points_in_mm), "mm\" viewBox=\"0 0 ", hundredth(drawn.width),
             " ", hundredth(drawn.height),
             "\" font-family=\"Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', sans-serif\" fill=\"#222222\">\n");
  append_all(svg, "<title>", escaped(title), "</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
             drawn.elements, "</svg>\n");
  return svg;
}

std::string figure_svg(const Figure& figure, const FigureStyle& style) {
  const DrawnFigure drawn = draw_figure(figure, style, "plot");
  if (style.height && drawn.height > *style.height * points_in_mm + 0.01) {
    log_warning("--size: the picture is " + std::to_string(std::lround(drawn.height / points_in_mm)) +
                " mm high, as its texts leave no room for less; see --no-title and --no-legend");
  }
  return svg_document(figure.what, drawn);
}

}  // namespace lober::cli
