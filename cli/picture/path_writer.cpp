#include "cli/picture/path_writer.hpp"

#include <algorithm>
#include <cmath>

#include "cli/report/text.hpp"
#include "lober/curve/drawing.hpp"

namespace lober::cli {
namespace {

// Segments may be 1e18 long where the window is 1e-12 wide: where they meet its sides is computed with more digits.
using Real = long double;
struct Spot {
  Real x, y;
};
struct Border {
  Real min_x, min_y, max_x, max_y;
  [[nodiscard]] bool contains(const Spot& p) const {
    return p.x >= min_x && p.x <= max_x && p.y >= min_y && p.y <= max_y;
  }
};

Border border_of(const View& view, double margin) {
  const Rectangle& window = view.window();
  const Real x = margin * view.unit_x(), y = margin * view.unit_y();
  return {window.min_x - x, window.min_y - y, window.max_x + x, window.max_y + y};
}

// Cuts the segment down to the border (Liang & Barsky, ACM Trans. Graph. 3, 1984); false if nothing is left.
bool clip(Spot& a, Spot& b, const Border& border) {
  const Spot from = a, step{b.x - a.x, b.y - a.y};
  Real first = 0, last = 1;
  const auto keep = [&](Real speed, Real limit) {  // speed t <= limit
    if (speed == 0) return limit >= 0;
    (speed < 0 ? first : last) = speed < 0 ? std::max(first, limit / speed) : std::min(last, limit / speed);
    return first <= last;
  };
  if (!keep(-step.x, from.x - border.min_x) || !keep(step.x, border.max_x - from.x)) return false;
  if (!keep(-step.y, from.y - border.min_y) || !keep(step.y, border.max_y - from.y)) return false;
  const auto at = [&](Real t) {
    return Spot{std::clamp(from.x + t * step.x, border.min_x, border.max_x),
                std::clamp(from.y + t * step.y, border.min_y, border.max_y)};
  };
  if (last < 1) b = at(last);
  if (first > 0) a = at(first);
  return true;
}

bool is_finite(Point point) {
  return std::isfinite(point.x) && std::isfinite(point.y);
}

}  // namespace

int path_unit(double points) {
  return static_cast<int>(std::lround(points * path_units));
}

std::vector<std::vector<PrintPoint>> clipped_line(const View& view, std::span<const Point> line, bool closed,
                                                  double margin) {
  const Border border = border_of(view, margin);
  std::vector<std::vector<PrintPoint>> parts;
  std::vector<PrintPoint> part;
  const auto finish = [&] {
    if (part.size() > 1) parts.push_back(std::move(part));
    part.clear();
  };
  const std::size_t segments = line.size() < 2 ? 0 : closed ? line.size() : line.size() - 1;
  for (std::size_t k = 0; k < segments; ++k) {
    const Point p = line[k], q = line[k + 1 < line.size() ? k + 1 : 0];
    if (!is_finite(p) || !is_finite(q)) {
      finish();
      continue;
    }
    Spot a{p.x, p.y}, b{q.x, q.y};
    if (!border.contains(a) || !border.contains(b)) {
      const Spot end = b;
      if (!clip(a, b, border)) {
        finish();
        continue;
      }
      if (part.empty()) part.push_back(view.at(a.x, a.y));
      part.push_back(view.at(b.x, b.y));
      if (b.x != end.x || b.y != end.y) finish();
      continue;
    }
    if (part.empty()) part.push_back(view.at(a.x, a.y));
    part.push_back(view.at(b.x, b.y));
  }
  finish();
  return parts;
}

// Sutherland & Hodgman, Commun. ACM 17, 1974.
std::vector<PrintPoint> clipped_polygon(const View& view, std::span<const Point> polygon, double margin) {
  const Border border = border_of(view, margin);
  std::vector<Spot> spots;
  spots.reserve(polygon.size());
  bool leaves = false;
  for (const Point& point : polygon) {
    if (!is_finite(point)) continue;
    spots.push_back({point.x, point.y});
    leaves = leaves || !border.contains(spots.back());
  }
  const auto cut = [&](Real Spot::*axis, Real Spot::*other, Real limit, int sign) {
    std::vector<Spot> kept;
    for (std::size_t k = 0; k < spots.size(); ++k) {
      const Spot a = spots[k], b = spots[k + 1 < spots.size() ? k + 1 : 0];
      const bool a_in = sign * (a.*axis - limit) <= 0, b_in = sign * (b.*axis - limit) <= 0;
      if (a_in) kept.push_back(a);
      if (a_in == b_in) continue;
      Spot met{};
      met.*axis = limit;
      met.*other = a.*other + (limit - a.*axis) / (b.*axis - a.*axis) * (b.*other - a.*other);
      kept.push_back(met);
    }
    spots = std::move(kept);
  };
  if (leaves) {
    cut(&Spot::x, &Spot::y, border.min_x, -1);
    cut(&Spot::x, &Spot::y, border.max_x, 1);
    cut(&Spot::y, &Spot::x, border.min_y, -1);
    cut(&Spot::y, &Spot::x, border.max_y, 1);
  }
  std::vector<PrintPoint> result;
  result.reserve(spots.size());
  for (const Spot& spot : spots) result.push_back(view.at(spot.x, spot.y));
  return result;
}

void PathWriter::add_polygon(std::span<const Point> polygon) {
  if (full_) return;
  constexpr double beyond = 20;  // sides along the border are not seen
  const std::vector<PrintPoint> drawn = simplified_line(clipped_polygon(view_, polygon, beyond), tolerance_);
  if (drawn.size() >= 3) draw(drawn, true);
}

void PathWriter::add_line(std::span<const Point> line, bool closed) {
  if (full_) return;
  constexpr double beyond = 4;  // joins of wide lines are not seen
  const Frame& frame = view_.frame();
  const double left = frame.x - beyond, top = frame.y - beyond;
  Coverage coverage(frame.width + 2 * beyond, frame.height + 2 * beyond, std::max(0.12, tolerance_));
  for (const std::vector<PrintPoint>& part : clipped_line(view_, line, closed, beyond)) {
    const std::vector<PrintPoint> kept = simplified_line(part, tolerance_);
    const bool whole = closed && part.size() == line.size() + 1;
    std::size_t first = 0;
    for (std::size_t k = 0; k + 1 < kept.size() && !whole; ++k) {
      const PrintPoint a = kept[k], b = kept[k + 1];
      if (coverage.mark({a.x - left, a.y - top}, {b.x - left, b.y - top})) continue;
      draw(std::span(kept).subspan(first, k + 1 - first), false);
      first = k + 1;
    }
    whole ? draw(std::span(kept).first(kept.size() - 1), true) : draw(std::span(kept).subspan(first), false);
  }
}

void PathWriter::draw(std::span<const PrintPoint> line, bool closed) {
  if (full_ || line.size() < 2) return;
  full_ = line.size() > points_left_;
  if (full_) return;
  points_left_ -= line.size();
  int x = path_unit(line[0].x), y = path_unit(line[0].y);
  append_all(path_, "M", x, " ", y, "l");
  for (std::size_t k = 1; k < line.size(); ++k) {
    const int next_x = path_unit(line[k].x), next_y = path_unit(line[k].y);
    const int step_x = next_x - x, step_y = next_y - y;
    append_all(path_, k > 1 && step_x >= 0 ? " " : "", step_x, step_y >= 0 ? " " : "", step_y);
    x = next_x;
    y = next_y;
  }
  if (closed) path_ += "z";
}

}  // namespace lober::cli
