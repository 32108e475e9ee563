// Places for labels. Sizes are those of a picture of a thousand pixels: cells are few, and plain loops over them do.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "lober/curve/drawing.hpp"

namespace lober {
namespace {

constexpr double cell_pixels = 3;  // pixels
constexpr double label_gap = 2;    // between labels
// A cell with a line below the label is as bad as this many pixels of distance from its point.
constexpr double line_cost = 6;

// Sixteen directions, those in which a label reads best first; rational, so that no picture depends on a library.
constexpr std::array<Point, 16> label_directions{{{0.707, -0.707},
                                                  {1, 0},
                                                  {-0.707, -0.707},
                                                  {0.707, 0.707},
                                                  {-1, 0},
                                                  {-0.707, 0.707},
                                                  {0, -1},
                                                  {0, 1},
                                                  {0.924, -0.383},
                                                  {0.924, 0.383},
                                                  {-0.924, -0.383},
                                                  {-0.924, 0.383},
                                                  {0.383, -0.924},
                                                  {0.383, 0.924},
                                                  {-0.383, -0.924},
                                                  {-0.383, 0.924}}};

bool apart(const Rectangle& a, const Rectangle& b) {
  return a.max_x + label_gap <= b.min_x || b.max_x + label_gap <= a.min_x || a.max_y + label_gap <= b.min_y ||
         b.max_y + label_gap <= a.min_y;
}

}  // namespace

LabelLayout::LabelLayout(double width, double height)
    : width_(width),
      height_(height),
      columns_(static_cast<std::size_t>(width / cell_pixels) + 1),
      rows_(static_cast<std::size_t>(height / cell_pixels) + 1),
      lines_(columns_ * rows_) {}

std::size_t LabelLayout::cell_of(double coordinate, std::size_t cells) const {
  return static_cast<std::size_t>(std::clamp(coordinate / cell_pixels, 0.0, static_cast<double>(cells - 1)));
}

void LabelLayout::add_line(Point a, Point b) {
  if (!(std::max(a.x, b.x) >= 0 && std::min(a.x, b.x) <= width_)) return;
  if (!(std::max(a.y, b.y) >= 0 && std::min(a.y, b.y) <= height_)) return;
  const double length = std::max(std::fabs(b.x - a.x), std::fabs(b.y - a.y));
  // Segments of curves are short; one that leaves the frame far behind is followed coarsely.
  const auto steps = static_cast<std::size_t>(std::min(4096.0, 2 * length / cell_pixels) + 1);
  for (std::size_t k = 0; k <= steps; ++k) {
    const double t = static_cast<double>(k) / static_cast<double>(steps);
    const Point at{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
    if (!(at.x >= 0 && at.x <= width_ && at.y >= 0 && at.y <= height_)) continue;
    lines_[cell_of(at.y, rows_) * columns_ + cell_of(at.x, columns_)] = 1;
  }
}

void LabelLayout::block(const Rectangle& rectangle) {
  blocked_.push_back(rectangle);
}

std::optional<LabelLayout::FreePlace> LabelLayout::roomiest(std::span<const Point> polygon, double flat) const {
  // Distance to the cells that are not free, by chamfer in two passes; a cell that is not inside has distance 0.
  std::vector<double> distance(columns_ * rows_, 0.0);
  std::vector<double> meets;
  for (std::size_t row = 0; row < rows_; ++row) {
    const double y = (static_cast<double>(row) + 0.5) * cell_pixels;
    meets.clear();
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Point a = polygon[k], b = polygon[k + 1 < polygon.size() ? k + 1 : 0];
      if ((a.y <= y) == (b.y <= y)) continue;
      meets.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
    }
    std::sort(meets.begin(), meets.end());
    for (std::size_t k = 0; k + 1 < meets.size(); k += 2) {
      for (std::size_t column = cell_of(meets[k], columns_); column < columns_; ++column) {
        const double x = (static_cast<double>(column) + 0.5) * cell_pixels;
        if (x >= meets[k + 1]) break;
        if (x > meets[k] && x < width_ && y < height_ && lines_[row * columns_ + column] == 0) {
          distance[row * columns_ + column] = std::numeric_limits<double>::infinity();
        }
      }
    }
  }
  for (const Rectangle& box : blocked_) {
    for (std::size_t row = cell_of(box.min_y, rows_); row <= cell_of(box.max_y, rows_); ++row) {
      for (std::size_t column = cell_of(box.min_x, columns_); column <= cell_of(box.max_x, columns_); ++column) {
        distance[row * columns_ + column] = 0;
      }
    }
  }
  const double across = cell_pixels / flat, up = cell_pixels, diagonal = std::hypot(across, up);
  const auto at = [&](std::size_t row, std::size_t column) -> double& { return distance[row * columns_ + column]; };
  // The border of the frame is not free.
  for (std::size_t row = 0; row < rows_; ++row) at(row, 0) = at(row, columns_ - 1) = 0;
  for (std::size_t column = 0; column < columns_; ++column) at(0, column) = at(rows_ - 1, column) = 0;
  for (std::size_t row = 1; row + 1 < rows_; ++row) {
    for (std::size_t column = 1; column + 1 < columns_; ++column) {
      at(row, column) = std::min({at(row, column), at(row, column - 1) + across, at(row - 1, column) + up,
                                  at(row - 1, column - 1) + diagonal, at(row - 1, column + 1) + diagonal});
    }
  }
  std::optional<FreePlace> best;
  for (std::size_t row = rows_ - 2; row > 0; --row) {
    for (std::size_t column = columns_ - 2; column > 0; --column) {
      at(row, column) = std::min({at(row, column), at(row, column + 1) + across, at(row + 1, column) + up,
                                  at(row + 1, column + 1) + diagonal, at(row + 1, column - 1) + diagonal});
      if (at(row, column) > (best ? best->distance : 0)) {
        best = FreePlace{
            {(static_cast<double>(column) + 0.5) * cell_pixels, (static_cast<double>(row) + 0.5) * cell_pixels},
            at(row, column)};
      }
    }
  }
  return best;
}

bool LabelLayout::free(const Rectangle& box) const {
  if (!(box.min_x >= 0 && box.max_x <= width_ && box.min_y >= 0 && box.max_y <= height_)) return false;
  return std::all_of(blocked_.begin(), blocked_.end(), [&](const Rectangle& other) { return apart(box, other); });
}

std::size_t LabelLayout::lines_below(const Rectangle& box) const {
  std::size_t count = 0;
  for (std::size_t row = cell_of(box.min_y, rows_); row <= cell_of(box.max_y, rows_); ++row) {
    for (std::size_t column = cell_of(box.min_x, columns_); column <= cell_of(box.max_x, columns_); ++column) {
      count += lines_[row * columns_ + column];
    }
  }
  return count;
}

std::optional<Rectangle> LabelLayout::put_about(Point at, double width, double height, double reach) {
  const auto about = [&](Point centre) {
    return Rectangle{centre.x - 0.5 * width, centre.y - 0.5 * height, centre.x + 0.5 * width, centre.y + 0.5 * height};
  };
  std::optional<Rectangle> best;
  double best_cost = std::numeric_limits<double>::infinity();
  const auto consider = [&](const Rectangle& box, double distance) {
    if (distance >= best_cost || !free(box)) return;
    const double cost = distance + line_cost * static_cast<double>(lines_below(box));
    if (cost >= best_cost) return;
    best = box;
    best_cost = cost;
  };
  consider(about(at), 0);
  double distance = 4;
  while (distance <= reach) {
    for (const Point& direction : label_directions) {
      consider(about({at.x + distance * direction.x, at.y + distance * direction.y}), distance);
    }
    distance *= 1.2;
  }
  if (best) block(*best);
  return best;
}

std::optional<Rectangle> LabelLayout::put_beside(Point at, double radius, double width, double height, double reach) {
  std::optional<Rectangle> best;
  double best_cost = std::numeric_limits<double>::infinity();
  double distance = radius + 2;
  while (distance <= reach) {
    for (std::size_t k = 0; k < label_directions.size(); ++k) {
      // The point of the box that is nearest to the dot lies at this distance.
      const Point direction = label_directions[k];
      const Point corner{at.x + distance * direction.x, at.y + distance * direction.y};
      const double left = corner.x - (direction.x > 0.2 ? 0 : direction.x < -0.2 ? width : 0.5 * width);
      const double top = corner.y - (direction.y > 0.2 ? 0 : direction.y < -0.2 ? height : 0.5 * height);
      const Rectangle box{left, top, left + width, top + height};
      if (distance >= best_cost || !free(box)) continue;
      const double cost = distance + 0.2 * static_cast<double>(k) + line_cost * static_cast<double>(lines_below(box));
      if (cost >= best_cost) continue;
      best = box;
      best_cost = cost;
    }
    distance = 1.2 * distance + 1;
  }
  if (best) block(*best);
  return best;
}

}  // namespace lober
