#include "cli/picture/inset.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "cli/picture/axes_svg.hpp"
#include "cli/picture/layers_svg.hpp"
#include "cli/picture/path_writer.hpp"
#include "cli/picture/rich_text.hpp"
#include "cli/report/text.hpp"

namespace lober::cli {
namespace {

constexpr double inset_tick_size = min_text_size, inset_gap = 3;

// Parts of the plot's sides that an inset has, and how many hidden cells of the occupancy each is worth.
struct InsetShare {
  double side, cells;
};
constexpr std::array<InsetShare, 4> inset_shares{{{0.46, 0}, {0.42, 4}, {0.36, 14}, {0.3, 30}}};
constexpr int inset_steps = 12;  // across, and down

// The lengths of lines and outlines, and the number of dots, on a coarse grid over the plot.
class Occupancy {
 public:
  Occupancy(const Figure& figure, const View& view) : frame_(view.frame()) {
    for (const Layer& layer : figure.layers) {
      for (const Polyline& line : layer.lines) {
        for (const auto& part : clipped_line(view, line.points(), line.closed, 0)) {
          for (std::size_t k = 0; k + 1 < part.size(); ++k) add_segment(part[k], part[k + 1]);
        }
      }
      for (const Point& point : layer.points) {
        if (view.contains(point)) count(view(point)) += 1;
      }
    }
  }
  [[nodiscard]] double within(const Frame& box) const {
    double sum = 0;
    for (std::size_t row = 0; row < side; ++row) {
      for (std::size_t column = 0; column < side; ++column) {
        const double x = frame_.x + (static_cast<double>(column) + 0.5) / side * frame_.width;
        const double y = frame_.y + (static_cast<double>(row) + 0.5) / side * frame_.height;
        if (x > box.x && x < box.right() && y > box.y && y < box.bottom())
          sum += std::min(1.0, cells_[row * side + column]);
      }
    }
    return sum;
  }

 private:
  static constexpr std::size_t side = 40;

  double& count(PrintPoint at) {
    const auto cell = [](double fraction) {
      return static_cast<std::size_t>(std::clamp(fraction * side, 0.0, side - 1.0));
    };
    return cells_[cell((at.y - frame_.y) / frame_.height) * side + cell((at.x - frame_.x) / frame_.width)];
  }
  void add_segment(PrintPoint a, PrintPoint b) {
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const int steps = std::max(1, static_cast<int>(length / 3));
    for (int k = 0; k < steps; ++k) {
      const double t = (k + 0.5) / steps;
      count({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}) += length / steps;
    }
  }

  Frame frame_;
  std::array<double, side * side> cells_{};
};

// The window in the plot, at least two points of print wide.
Frame source_of(const View& plot, const Rectangle& window) {
  const PrintPoint a = plot({window.min_x, window.max_y}), b = plot({window.max_x, window.min_y});
  Frame frame{a.x, a.y, b.x - a.x, b.y - a.y};
  const double x = std::max(0.0, 2 - frame.width), y = std::max(0.0, 2 - frame.height);
  return {frame.x - x / 2, frame.y - y / 2, frame.width + x, frame.height + y};
}

// Whether the axis is named in an inset too: where its ticks count from another number, or in another unit, than those
// of the plot.
bool has_name(const Ticks& ticks) {
  return ticks.power != 0 || !ticks.offset.empty();
}

double shared_area(const Frame& a, const Frame& b) {
  const double width = std::min(a.right(), b.right()) - std::max(a.x, b.x);
  const double height = std::min(a.bottom(), b.bottom()) - std::max(a.y, b.y);
  return width > 0 && height > 0 ? width * height : 0;
}

}  // namespace

Inset::Inset(const Figure& figure, const View& plot, const Rectangle& window)
    : figure_(figure), plot_(plot), window_(window) {
  const Frame& all = plot.frame();
  const Occupancy occupancy(figure, plot);
  const Frame source = source_of(plot, window);
  double least = HUGE_VAL;
  for (const InsetShare& share : inset_shares) {
    const Frame room{0, 0, share.side * all.width, share.side * all.height};
    Frame inner = figure.plane ? fitted_frame(window, room) : room;
    const Ticks across = ticks_across(window, inner.width, inset_tick_size, figure.x);
    const Ticks up = ticks_up(window, inner.height, inset_tick_size, figure.y);
    const double name = inset_tick_size + 2;
    const double left = widest(up, inset_tick_size) + 6 + (has_name(up) ? name : 0);
    const double below = inset_tick_size + 5 + (has_name(across) ? name : 0);
    const double right = std::max(2.0, 0.4 * widest(across, inset_tick_size));
    const double width = inner.width + left + right, height = inner.height + below + 3;
    const double free_x = all.width - width - 2 * inset_gap, free_y = all.height - height - 2 * inset_gap;
    if (free_x < 0 || free_y < 0) continue;
    for (int row = 0; row <= inset_steps; ++row) {
      for (int column = 0; column <= inset_steps; ++column) {
        const Frame box{all.x + inset_gap + free_x * column / inset_steps,
                        all.y + inset_gap + free_y * row / inset_steps, width, height};
        // Corners first, where all else is equal.
        const int to_side = std::min(column, inset_steps - column), to_end = std::min(row, inset_steps - row);
        const double hidden =
            occupancy.within(box) + share.cells + 1e3 * shared_area(box, source) + 0.3 * (to_side + to_end);
        if (hidden >= least) continue;
        least = hidden;
        outer_ = box;
        inner.x = box.x + left;
        inner.y = box.y + 3;
        inner_ = inner;
        across_ = across;
        up_ = up;
      }
    }
  }
}

void Inset::draw(std::string& svg) const {
  const Frame source = source_of(plot_, window_);
  const auto rectangle = [&](const Frame& frame, const char* style) {
    append_all(svg, "<rect x=\"", hundredth(frame.x), "\" y=\"", hundredth(frame.y), "\" width=\"",
               hundredth(frame.width), "\" height=\"", hundredth(frame.height), "\" ", style, "/>\n");
  };
  const Frame& all = plot_.frame();
  const bool in_plot =
      source.right() > all.x && source.x < all.right() && source.bottom() > all.y && source.y < all.bottom();
  if (in_plot) rectangle(source, "fill=\"none\" stroke=\"#222222\" stroke-width=\"0.5\"");
  const auto corners = [](const Frame& f) {
    return std::array<PrintPoint, 4>{{{f.x, f.y}, {f.right(), f.y}, {f.right(), f.bottom()}, {f.x, f.bottom()}}};
  };
  // Equal corners are joined where the line passes through neither rectangle: left and right ones above or below, ...
  const auto from = corners(source), to = corners(inner_);
  const auto crosses = [](const Frame& f, PrintPoint a, PrintPoint b) {
    for (int k = 1; k < 40; ++k) {
      const double t = k / 40.0, x = a.x + t * (b.x - a.x), y = a.y + t * (b.y - a.y);
      if (x > f.x && x < f.right() && y > f.y && y < f.bottom()) return true;
    }
    return false;
  };
  for (std::size_t k = 0; k < 4 && in_plot; ++k) {
    if (crosses(source, from[k], to[k]) || crosses(inner_, from[k], to[k])) continue;
    append_all(svg, "<path d=\"M", hundredth(from[k].x), " ", hundredth(from[k].y), "L", hundredth(to[k].x), " ",
               hundredth(to[k].y), "\" stroke=\"#666666\" stroke-width=\"0.35\"/>\n");
  }
  rectangle(outer_, "fill=\"#ffffff\"");
  const View view(window_, inner_);
  add_layers(svg, figure_, view, "inset");
  add_labels(svg, figure_, view, nullptr, 0.85);
  add_axes(svg, view, across_, up_, inset_tick_size);
  const TextStyle style{.size = inset_tick_size, .anchor = "middle"};
  if (has_name(across_)) {
    add_text(svg, inner_.x + 0.5 * inner_.width, outer_.bottom() - 1, axis_text(figure_.x, across_), style);
  }
  if (has_name(up_)) {
    TextStyle upward = style;
    upward.upward = true;
    add_text(svg, outer_.x + inset_tick_size, inner_.y + 0.5 * inner_.height, axis_text(figure_.y, up_), upward);
  }
}

}  // namespace lober::cli
