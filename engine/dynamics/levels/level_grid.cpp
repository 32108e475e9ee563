#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "engine/base/parallel/parallel.hpp"
#include "lober/base/error.hpp"
#include "lober/dynamics/levels.hpp"

namespace lober {
namespace {

constexpr std::size_t nodes_a_task = 256;  // nodes
constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

double between(double low, double high, std::size_t k, std::size_t parts) {
  const double t = static_cast<double>(k) / static_cast<double>(parts);
  return low * (1 - t) + high * t;
}

// Where the function passes the level between a point above (or on) it and one below, to rounding.
Point passage(const PlaneFunction& function, double level, Point above, Point below) {
  for (int round = 0; round < 100; ++round) {
    const Point middle{0.5 * (above.x + below.x), 0.5 * (above.y + below.y)};
    if (middle == above || middle == below) break;
    (function(middle) >= level ? above : below) = middle;
  }
  return above;
}

}  // namespace

LevelGrid::LevelGrid(PlaneFunction function, const Rectangle& window, std::size_t columns, std::size_t rows)
    : function_(std::move(function)), window_(window), columns_(columns), rows_(rows) {
  if (!(window.width() > 0 && window.height() > 0)) throw UsageError("the window of a grid needs an area");
  if (columns == 0 || rows == 0) throw UsageError("a grid needs at least one cell");
  // Sides of cells have 32-bit numbers.
  if (columns > 30'000 || rows > 30'000) throw UsageError("a grid can have at most 30000 columns and 30000 rows");
  values_.resize((columns + 1) * (rows + 1));
  detail::for_each_block(values_.size(), nodes_a_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) values_[k] = function_(node(k % (columns_ + 1), k / (columns_ + 1)));
  });
}

Point LevelGrid::node(std::size_t column, std::size_t row) const {
  return {between(window_.min_x, window_.max_x, column, columns_), between(window_.min_y, window_.max_y, row, rows_)};
}

std::vector<LevelCurve> LevelGrid::curves(double level) const {
  // Sides of cells: the horizontal ones, row by row, then the vertical ones.
  const std::size_t horizontal = columns_ * (rows_ + 1), sides = horizontal + (columns_ + 1) * rows_;
  std::vector<std::uint32_t> next(sides, none);
  std::vector<bool> entered(sides);
  for (std::size_t row = 0; row < rows_; ++row) {
    for (std::size_t column = 0; column < columns_; ++column) {
      // Corners and the sides after them, counter-clockwise from the lower left.
      const std::array<double, 4> corner{value(column, row), value(column + 1, row), value(column + 1, row + 1),
                                         value(column, row + 1)};
      if (!std::all_of(corner.begin(), corner.end(), [](double v) { return std::isfinite(v); })) continue;
      const std::array<std::size_t, 4> side{row * columns_ + column, horizontal + row * (columns_ + 1) + column + 1,
                                            (row + 1) * columns_ + column, horizontal + row * (columns_ + 1) + column};
      std::array<bool, 4> above{};
      for (std::size_t k = 0; k < 4; ++k) above[k] = corner[k] >= level;
      const double mean = 0.25 * (corner[0] + corner[1] + corner[2] + corner[3]);
      const bool two = above[0] == above[2] && above[1] == above[3] && above[0] != above[1];
      for (std::size_t k = 0; k < 4; ++k) {
        // A curve with what is above on its left comes in where the border of the cell leaves that.
        if (!above[k] || above[(k + 1) % 4]) continue;
        std::size_t out = (k + 1) % 4;
        if (two && mean < level) {
          out = (k + 3) % 4;
        } else {
          while (above[out] || !above[(out + 1) % 4]) out = (out + 1) % 4;
        }
        next[side[k]] = static_cast<std::uint32_t>(side[out]);
        entered[side[out]] = true;
      }
    }
  }
  const auto point_on = [&](std::size_t side) {
    const bool across = side < horizontal;
    const std::size_t width = across ? columns_ : columns_ + 1, number = across ? side : side - horizontal;
    const std::size_t column = number % width, row = number / width;
    const std::size_t column2 = across ? column + 1 : column, row2 = across ? row : row + 1;
    const Point a = node(column, row), b = node(column2, row2);
    return value(column, row) >= level ? passage(function_, level, a, b) : passage(function_, level, b, a);
  };
  std::vector<LevelCurve> result;
  const auto follow = [&](std::size_t first, bool closed) {
    LevelCurve curve;
    curve.closed = closed;
    std::size_t side = first;
    do {
      curve.points.push_back(point_on(side));
      side = std::exchange(next[side], none);
    } while (side != none && side != first && next[side] != none);
    if (!closed && side != none) curve.points.push_back(point_on(side));
    result.push_back(std::move(curve));
  };
  for (const bool closed : {false, true}) {
    for (std::size_t side = 0; side < sides; ++side) {
      if (next[side] != none && (closed || !entered[side])) follow(side, closed);
    }
  }
  return result;
}

}  // namespace lober
