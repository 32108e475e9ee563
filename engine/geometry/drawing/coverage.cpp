#include <algorithm>
#include <cmath>

#include "lober/curve/drawing.hpp"

namespace lober {
using namespace detail;

Coverage::Coverage(double width, double height, double cell)
    : cell_(cell),
      columns_(static_cast<std::size_t>(width / cell) + 1),
      rows_(static_cast<std::size_t>(height / cell) + 1),
      marked_(columns_ * rows_) {}

bool Coverage::mark(Point a, Point b) {
  const auto steps = static_cast<std::size_t>(std::ceil(std::hypot(b.x - a.x, b.y - a.y) / cell_));
  bool any = false;
  for (std::size_t k = 0; k <= steps; ++k) {
    const double t = steps > 0 ? static_cast<double>(k) / static_cast<double>(steps) : 0;
    const double x = std::max(0.0, a.x + t * (b.x - a.x)) / cell_, y = std::max(0.0, a.y + t * (b.y - a.y)) / cell_;
    const std::size_t column = std::min(columns_ - 1, static_cast<std::size_t>(x));
    const std::size_t row = std::min(rows_ - 1, static_cast<std::size_t>(y));
    const std::size_t cell = row * columns_ + column;
    if (marked_[cell]) continue;
    marked_[cell] = true;
    any = true;
  }
  return any;
}

}  // namespace lober
