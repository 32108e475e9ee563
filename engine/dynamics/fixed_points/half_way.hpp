// Periodic points where half a way on and half a way back meet.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "engine/dynamics/maps/plane.hpp"
#include "lober/dynamics/planar_map.hpp"

namespace lober::detail {

/// z -> z + h^a(z) - h^-b(z), with h^(a + b) = f^k: the points that it shifts by some vector after which h repeats
/// itself are those that f^k does. Near a saddle of multiplier lambda Newton's method for f^k converges from within
/// about 1 / lambda of it, for this map from within 1 / sqrt(lambda): a grid sees points here that it would have to be
/// lambda times as fine for otherwise. Away from those points it is not a map of any flow, and it has no inverse.
class HalfWayMap final : public PlanarMap {
 public:
  /// h is half a step of f.
  explicit HalfWayMap(std::unique_ptr<PlanarMap> half) : half_(std::move(half)), step_(*half_) {}
  /// h is f itself; b = k / 2, rounded down.
  explicit HalfWayMap(const PlanarMap& whole) : step_(whole) {}

  /// Whether f^period stretches more, and there is a way back.
  [[nodiscard]] bool helps(int period) const { return half_ != nullptr || (period > 1 && step_.takes_all_iterates()); }
  /// Whether the work counted here is not that of f.
  [[nodiscard]] bool counts_apart() const { return half_ != nullptr; }

  /// 1, or -1 where f^-b reverses orientation: the displacements of this map along a closed path are those of f^period
  /// along its image under f^-b, whose points have the indices of those here, times this. `at`: any point with images.
  [[nodiscard]] int orientation(int period, Point at) const {
    Matrix2 derivative;
    step_.iterate_with_derivative(at, -1, derivative);
    return determinant(derivative) < 0 && steps_back(period) % 2 != 0 ? -1 : 1;
  }

  void iterate(std::span<Point> points, int iterates) const override {
    std::vector<Point> behind(points.begin(), points.end()), ahead = behind;
    step_.iterate(ahead, steps_on(iterates));
    step_.iterate(behind, -steps_back(iterates));
    for (std::size_t k = 0; k < points.size(); ++k) points[k] = apart(points[k], ahead[k], behind[k]);
  }
  Point iterate_with_derivative(Point point, int iterates, Matrix2& derivative) const override {
    iterate_with_derivatives({&point, 1}, iterates, {&derivative, 1});
    return point;
  }
  void iterate_with_derivatives(std::span<Point> points, int iterates, std::span<Matrix2> derivatives) const override {
    std::vector<Point> behind(points.begin(), points.end()), ahead = behind;
    std::vector<Matrix2> back(points.size());
    step_.iterate_with_derivatives(ahead, steps_on(iterates), derivatives);
    step_.iterate_with_derivatives(behind, -steps_back(iterates), back);
    for (std::size_t k = 0; k < points.size(); ++k) {
      points[k] = apart(points[k], ahead[k], behind[k]);
      Matrix2& d = derivatives[k];
      d = {1 + d.xx - back[k].xx, d.xy - back[k].xy, d.yx - back[k].yx, 1 + d.yy - back[k].yy};
    }
  }
  [[nodiscard]] double unit() const override { return step_.unit(); }
  [[nodiscard]] std::size_t batch() const override { return step_.batch(); }
  [[nodiscard]] std::uint64_t work() const override { return step_.work(); }
  [[nodiscard]] std::uint64_t work_of_derivatives() const override { return step_.work_of_derivatives(); }

 private:
  static Point apart(Point z, Point ahead, Point behind) {
    return {z.x + (ahead.x - behind.x), z.y + (ahead.y - behind.y)};
  }
  [[nodiscard]] int steps_back(int iterates) const { return half_ ? iterates : iterates / 2; }
  [[nodiscard]] int steps_on(int iterates) const { return half_ ? iterates : iterates - iterates / 2; }

  std::unique_ptr<PlanarMap> half_;
  const PlanarMap& step_;
};

/// By half steps of a map that has such, by steps of itself otherwise. The map has to outlive it.
inline HalfWayMap half_way_map(const PlanarMap& map) {
  std::unique_ptr<PlanarMap> half = map.half();
  return half ? HalfWayMap(std::move(half)) : HalfWayMap(map);
}

}  // namespace lober::detail
