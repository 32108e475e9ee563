#include "cli/picture/legend.hpp"

#include <algorithm>
#include <cmath>

#include "cli/picture/path_writer.hpp"
#include "cli/picture/rich_text.hpp"
#include "cli/report/text.hpp"

namespace lober::cli {
namespace {

constexpr double font_size = 7, line_step = 8.6, row_gap = 1.4, sample_width = 14, text_indent = 18, column_gap = 10;
constexpr std::size_t max_columns = 5, max_lines = 4;

void add_sample(std::string& svg, const Layer& layer) {
  switch (layer.kind) {
    case LayerKind::fill:
      append_all(svg, "<rect y=\"-3.5\" width=\"", sample_width, "\" height=\"7\" fill=\"", layer.colour,
                 "\" fill-opacity=\"", layer.opacity, "\"/>");
      break;
    case LayerKind::boxes:
      append_all(svg, "<rect y=\"-3.5\" width=\"", sample_width, "\" height=\"7\" fill=\"", layer.colour, "\"/>");
      break;
    case LayerKind::line:
      append_all(svg, "<path d=\"M0 0h", sample_width, "\" stroke=\"", layer.colour, "\" stroke-width=\"",
                 std::max(0.7, layer.width), "\"", layer.dashed ? " stroke-dasharray=\"3 2\"" : "", "/>");
      if (layer.arrow_at_end || layer.arrows > 0) {
        append_all(svg, "<path d=\"M", sample_width, " 0l-4 -1.6v3.2z\" fill=\"", layer.colour, "\"/>");
      }
      break;
    case LayerKind::dots:
      if (!layer.errors.empty()) {
        append_all(svg, "<path d=\"M", sample_width / 2, " -3.5v7\" stroke=\"", layer.colour,
                   "\" stroke-width=\"0.5\"/>");
      }
      add_dot(svg, layer, sample_width / 2, 0, 1);
  }
}

// Whether a window shows any of a layer. Layers of nothing but a legend are for others that they explain.
bool is_seen(const Layer& layer, const Rectangle& window) {
  if (layer.lines.empty() && layer.points.empty() && layer.boxes.empty()) return true;
  const View view(window, {0, 0, 100, 100});
  const auto holds = [&](const Polyline& line) {
    return layer.kind == LayerKind::fill ? !clipped_polygon(view, line.points(), 0).empty()
                                         : !clipped_line(view, line.points(), line.closed, 0).empty();
  };
  const auto overlaps = [&](const Rectangle& box) {
    return box.min_x < window.max_x && box.max_x > window.min_x && box.min_y < window.max_y && box.max_y > window.min_y;
  };
  return std::any_of(layer.lines.begin(), layer.lines.end(), holds) ||
         std::any_of(layer.points.begin(), layer.points.end(), [&](Point point) { return view.contains(point); }) ||
         std::any_of(layer.boxes.begin(), layer.boxes.end(), overlaps);
}

}  // namespace

void add_dot(std::string& svg, const Layer& layer, double x, double y, double scale) {
  const auto number = [&](double value) { return scale == 1 ? hundredth(value) : std::round(value); };
  const double r = layer.radius * scale;
  switch (layer.shape) {
    case DotShape::circle:
      append_all(svg, "<circle cx=\"", number(x), "\" cy=\"", number(y), "\" r=\"", number(r), "\"");
      break;
    case DotShape::square:
      append_all(svg, "<path d=\"M", number(x - r), " ", number(y - r), "h", number(2 * r), "v", number(2 * r), "h",
                 number(-2 * r), "z\"");
      break;
    case DotShape::triangle:
      append_all(svg, "<path d=\"M", number(x), " ", number(y - 1.2 * r), "l", number(1.1 * r), " ", number(1.9 * r),
                 "h", number(-2.2 * r), "z\"");
      break;
    case DotShape::cross:
      append_all(svg, "<path d=\"M", number(x - r), " ", number(y - r), "l", number(2 * r), " ", number(2 * r), "m0 ",
                 number(-2 * r), "l", number(-2 * r), " ", number(2 * r), "\" fill=\"none\" stroke=\"", layer.colour,
                 "\" stroke-width=\"", number(scale), "\"/>\n");
      return;
  }
  if (layer.hollow) {
    append_all(svg, " fill=\"#ffffff\" stroke=\"", layer.colour, "\" stroke-width=\"", number(0.7 * scale), "\"/>\n");
  } else {
    append_all(svg, " fill=\"", layer.colour, "\" stroke=\"#ffffff\" stroke-width=\"", number(0.3 * scale), "\"/>\n");
  }
}

Legend::Legend(const Figure& figure, double width, const Rectangle* window) {
  const double text_room = width - text_indent;
  const auto add = [&](const Layer* layer, const std::string& text) {
    if (text.empty()) return;
    const std::vector<std::string> lines = wrapped(text, font_size, text_room, max_lines);
    for (const Entry& entry : entries_) {
      if (entry.lines == lines) return;
    }
    entries_.push_back({layer, lines, std::string(whole_of_cut(lines, text))});
  };
  for (const Layer& layer : figure.layers) {
    if (window == nullptr || is_seen(layer, *window)) add(&layer, layer.legend);
  }
  for (const std::string& note : figure.notes) add(nullptr, note);
  if (entries_.empty()) return;
  // In columns of one width; a longer entry takes several of them. The number of columns is the one with fewest rows.
  const auto entry_width = [](const Entry& entry) {
    double widest = 0;
    for (const std::string& line : entry.lines) widest = std::max(widest, text_width(line, font_size));
    return widest + (entry.layer == nullptr ? 0 : text_indent);
  };
  const auto arrange = [&](std::size_t columns) {
    const double step = (width + column_gap) / static_cast<double>(columns);
    std::vector<Position> positions;
    std::size_t row = 0, next = 0;
    for (const Entry& entry : entries_) {
      const auto wanted = static_cast<std::size_t>(std::ceil((entry_width(entry) + column_gap) / step));
      const std::size_t span = std::clamp<std::size_t>(wanted, 1, columns);
      if (next + span > columns) ++row, next = 0;
      positions.push_back({row, static_cast<double>(next) * step});
      next += span;
    }
    return positions;
  };
  positions_ = arrange(1);
  for (std::size_t columns = 2; columns <= max_columns; ++columns) {
    std::vector<Position> positions = arrange(columns);
    if (positions.back().row < positions_.back().row) positions_ = std::move(positions);
  }
  double y = 0;
  for (std::size_t k = 0; k < entries_.size();) {
    row_tops_.push_back(y);
    std::size_t lines = 1;
    const std::size_t row = positions_[k].row;
    for (; k < entries_.size() && positions_[k].row == row; ++k) lines = std::max(lines, entries_[k].lines.size());
    y += static_cast<double>(lines) * line_step + row_gap;
  }
  row_tops_.push_back(y);
}

double Legend::height() const {
  return row_tops_.empty() ? 0 : row_tops_.back();
}

void Legend::draw(std::string& svg, double x, double y) const {
  for (std::size_t k = 0; k < entries_.size(); ++k) {
    const Entry& entry = entries_[k];
    append_all(svg, "<g transform=\"translate(", hundredth(x + positions_[k].x), " ",
               hundredth(y + row_tops_[positions_[k].row] + line_step / 2), ")\">");
    if (entry.layer != nullptr) add_sample(svg, *entry.layer);
    for (std::size_t line = 0; line < entry.lines.size(); ++line) {
      add_text(svg, entry.layer != nullptr ? text_indent : 0, 0.36 * font_size + static_cast<double>(line) * line_step,
               entry.lines[line], {.size = font_size, .whole = entry.whole});
    }
    svg += "</g>\n";
  }
}

}  // namespace lober::cli
