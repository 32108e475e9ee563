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

/// z -> z + h^k(z) - h^-k(z), with h half a step of a map f (PlanarMap::half): the points that it shifts by some vector
/// are those that f^k does. Near a saddle of multiplier lambda Newton's method for f converges from within about 1 /
/// lambda of it, for this map from within 1 / sqrt(lambda): a grid sees points here that it would have to be lambda
/// times as fine for otherwise. Away from those points it is not a map of any flow, and it has no inverse.
class HalfWayMap final : public PlanarMap {
 public:
  explicit HalfWayMap(std::unique_ptr<PlanarMap> half) : half_(std::move(half)) {}

  void iterate(std::span<Point> points, int iterates) const override {
    std::vector<Point> behind(points.begin(), points.end()), ahead = behind;
    half_->iterate(ahead, iterates);
    half_->iterate(behind, -iterates);
    for (std::size_t k = 0; k < points.size(); ++k) points[k] = apart(points[k], ahead[k], behind[k]);
  }
  Point iterate_with_derivative(Point point, int iterates, Matrix2& derivative) const override {
    iterate_with_derivatives({&point, 1}, iterates, {&derivative, 1});
    return point;
  }
  void iterate_with_derivatives(std::span<Point> points, int iterates, std::span<Matrix2> derivatives) const override {
    std::vector<Point> behind(points.begin(), points.end()), ahead = behind;
    std::vector<Matrix2> back(points.size());
    half_->iterate_with_derivatives(ahead, iterates, derivatives);
    half_->iterate_with_derivatives(behind, -iterates, back);
    for (std::size_t k = 0; k < points.size(); ++k) {
      points[k] = apart(points[k], ahead[k], behind[k]);
      Matrix2& d = derivatives[k];
      d = {1 + d.xx - back[k].xx, d.xy - back[k].xy, d.yx - back[k].yx, 1 + d.yy - back[k].yy};
    }
  }
  [[nodiscard]] double unit() const override { return half_->unit(); }
  [[nodiscard]] std::size_t batch() const override { return half_->batch(); }
  [[nodiscard]] std::uint64_t work() const override { return half_->work(); }
  [[nodiscard]] std::uint64_t work_of_derivatives() const override { return half_->work_of_derivatives(); }

 private:
  static Point apart(Point z, Point ahead, Point behind) {
    return {z.x + (ahead.x - behind.x), z.y + (ahead.y - behind.y)};
  }

  std::unique_ptr<PlanarMap> half_;
};

/// That of a map whose steps have halves; null for others.
inline std::unique_ptr<HalfWayMap> half_way_map(const PlanarMap& map) {
  std::unique_ptr<PlanarMap> half = map.half();
  return half ? std::make_unique<HalfWayMap>(std::move(half)) : nullptr;
}

}  // namespace lober::detail
