#include "engine/base/parallel/parallel.hpp"
#include "lober/curve/drawing.hpp"

namespace lober {
using namespace detail;

Rectangle widened(const Rectangle& rectangle, double fraction) {
  // Halves, because a difference of two finite numbers need not be finite.
  const double x = 2 * fraction * (0.5 * rectangle.max_x - 0.5 * rectangle.min_x);
  const double y = 2 * fraction * (0.5 * rectangle.max_y - 0.5 * rectangle.min_y);
  return {rectangle.min_x - x, rectangle.min_y - y, rectangle.max_x + x, rectangle.max_y + y};
}

Buffer<Point> cell_centres(const Rectangle& window, std::size_t columns, std::size_t rows) {
  const auto middle = [](double low, double high, std::size_t cell, std::size_t cells) {
    const double half_cell = (0.5 * high - 0.5 * low) / static_cast<double>(cells);
    return low + half_cell * static_cast<double>(2 * cell + 1);
  };
  constexpr std::size_t grain = std::size_t{1} << 14;
  Buffer<Point> centres(columns * rows);
  for_each_block(centres.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      centres[k] = {middle(window.min_x, window.max_x, k % columns, columns),
                    middle(window.min_y, window.max_y, k / columns, rows)};
    }
  });
  return centres;
}

}  // namespace lober
