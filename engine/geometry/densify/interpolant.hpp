// The curve between the vertices (private to densify/).
#pragma once

#include "kernels/interpolation.hpp"
#include "lober/base/buffer.hpp"
#include "lober/curve/curve.hpp"
#include "lober/curve/densify.hpp"

namespace lober::detail {

/// An interpolation of a curve without repeated vertices, which has to stay alive. O(N) to make, parallel; O(1) a
/// piece.
class Interpolant {
 public:
  Interpolant(CurveView curve, Interpolation kind);

  [[nodiscard]] const CurveView& curve() const { return curve_; }
  [[nodiscard]] Interpolation kind() const { return kind_; }
  /// The piece of segment k.
  [[nodiscard]] CubicPiece piece(std::size_t k) const {
    const std::size_t next = k + 1 == curve_.points.size() ? 0 : k + 1;
    const Point a = curve_.points[k], b = curve_.points[next];
    switch (kind_) {
      case Interpolation::dritschel:
        return dritschel_piece(a, b, curvature_[k], curvature_[next]);
      case Interpolation::spline:
        return spline_piece(a, b, second_[k], second_[next]);
      case Interpolation::linear:
        break;
    }
    return linear_piece(a, b);
  }

 private:
  CurveView curve_;
  Interpolation kind_;
  Buffer<double> curvature_;
  Buffer<Point> second_;
};

}  // namespace lober::detail
