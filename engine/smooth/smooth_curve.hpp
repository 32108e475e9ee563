// A closed curve made of smooth segments (private to smooth/).
#pragma once

#include <array>
#include <cstdint>

#include "engine/curve/curve.hpp"
#include "kernels/smooth_segment.hpp"

namespace lober {

/// Numbers of vertices and segments wrap.
class SmoothCurve {
 public:
  explicit SmoothCurve(CurveView view) : view_(view), size_(static_cast<std::int64_t>(view.points.size())) {}

  [[nodiscard]] std::size_t segments() const { return view_.points.size(); }
  [[nodiscard]] Point vertex(std::int64_t k) const {
    if (k < 0 || k >= size_) k = (k % size_ + size_) % size_;
    return view_.points[static_cast<std::size_t>(k)];
  }
  /// Curves of fewer vertices than a segment looks at stay polygons.
  [[nodiscard]] SmoothSegment segment(std::int64_t k) const {
    if (size_ < 8) {
      const Point a = vertex(k), b = vertex(k + 1);
      SmoothSegment straight;
      straight.chord = {b.x - a.x, b.y - a.y};
      return straight;
    }
    std::array<Point, 8> window;
    for (std::int64_t j = 0; j < 8; ++j) window[static_cast<std::size_t>(j)] = vertex(k - 3 + j);
    return fit_smooth_segment(window);
  }

 private:
  CurveView view_;
  std::int64_t size_;
};

/// A place on a smooth curve. `segment` may lie a few segments outside the curve, so that places near the first vertex
/// keep their order.
struct SmoothPlace {
  std::int64_t segment = 0;
  double u = 0;
};

}  // namespace lober
