// The displacements f^period(z) - z - shift on a grid over a box: where Newton's method starts from.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "engine/dynamics/fixed_points/newton.hpp"
#include "engine/dynamics/maps/plane.hpp"
#include "lober/dynamics/fixed_points.hpp"

namespace lober::detail {

class DisplacementGrid {
 public:
  DisplacementGrid(const PlanarMap& map, const Rectangle& box, const FixedPointOptions& options)
      : box_(box), side_(static_cast<std::size_t>(options.grid)), gaps_(side_ * side_) {
    for_each_block(gaps_.size(), std::max(std::size_t{64}, map.batch()), [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) gaps_[k] = grid_point(k);
      map.iterate(std::span(gaps_).subspan(begin, end - begin), options.period);
      for (std::size_t k = begin; k < end; ++k) {
        gaps_[k] = gap_between(grid_point(k), gaps_[k], options);
      }
    });
  }

  /// The centres of cells on whose corners both components change sign, and the grid points where the length is least.
  [[nodiscard]] std::vector<Point> seeds() const {
    std::vector<Point> result;
    for (std::size_t j = 0; j < side_; ++j) {
      for (std::size_t i = 0; i < side_; ++i) {
        if (i + 1 < side_ && j + 1 < side_ && both_change_sign(i, j)) {
          const Point low = grid_point(j * side_ + i), high = grid_point((j + 1) * side_ + i + 1);
          result.push_back({0.5 * (low.x + high.x), 0.5 * (low.y + high.y)});
        }
        if (least_among_neighbours(i, j)) result.push_back(grid_point(j * side_ + i));
      }
    }
    return result;
  }

  /// Whether every grid point has an image.
  [[nodiscard]] bool all_have_images() const {
    return std::all_of(gaps_.begin(), gaps_.end(), [](Point gap) { return is_finite(gap); });
  }

  /// The diagonal of a cell.
  [[nodiscard]] double cell() const { return std::hypot(box_.width(), box_.height()) / static_cast<double>(side_ - 1); }

  /// The grid point of the smallest displacement, and that; NaN when no point of the grid has an image.
  [[nodiscard]] std::pair<Point, double> nearest() const {
    const auto least = std::min_element(gaps_.begin(), gaps_.end(), [](Point a, Point b) {
      return is_finite(a) && (!is_finite(b) || length(a) < length(b));
    });
    return {grid_point(static_cast<std::size_t>(least - gaps_.begin())), length(*least)};
  }

 private:
  [[nodiscard]] Point grid_point(std::size_t k) const {
    const std::size_t column = k % side_, row = k / side_;
    const double steps = static_cast<double>(side_ - 1);
    return {box_.min_x + box_.width() * (static_cast<double>(column) / steps),
            box_.min_y + box_.height() * (static_cast<double>(row) / steps)};
  }
  [[nodiscard]] bool both_change_sign(std::size_t i, std::size_t j) const {
    const std::array<Point, 4> corner{gaps_[j * side_ + i], gaps_[j * side_ + i + 1], gaps_[(j + 1) * side_ + i],
                                      gaps_[(j + 1) * side_ + i + 1]};
    const auto changes = [&](double Point::*part) {
      const bool any_up = std::any_of(corner.begin(), corner.end(), [&](Point g) { return g.*part >= 0; });
      const bool any_down = std::any_of(corner.begin(), corner.end(), [&](Point g) { return g.*part <= 0; });
      return any_up && any_down;
    };
    return changes(&Point::x) && changes(&Point::y);
  }
  [[nodiscard]] bool least_among_neighbours(std::size_t i, std::size_t j) const {
    const double here = length(gaps_[j * side_ + i]);
    if (!std::isfinite(here)) return false;
    for (std::size_t row = j == 0 ? 0 : j - 1; row <= std::min(j + 1, side_ - 1); ++row) {
      for (std::size_t column = i == 0 ? 0 : i - 1; column <= std::min(i + 1, side_ - 1); ++column) {
        if (length(gaps_[row * side_ + column]) < here) return false;
      }
    }
    return true;
  }

  Rectangle box_;
  std::size_t side_;
  std::vector<Point> gaps_;
};

}  // namespace lober::detail
