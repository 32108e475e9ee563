// A planar map: what curves and manifolds are carried along by. Maps given by formulas, stroboscopic maps of
// time-periodic flows and Poincare maps on a section all look like this.
#pragma once

#include <span>

#include "kernels/point.hpp"

namespace lober {

/// A 2 x 2 matrix, row by row.
struct Matrix2 {
  double xx = 1, xy = 0;
  double yx = 0, yy = 1;
};

/// A diffeomorphism of (a part of) the plane. Immutable: every call may come from several threads at the same time, and
/// a point has the same image, bit for bit, in whatever batch it comes.
class PlanarMap {
 public:
  PlanarMap() = default;
  PlanarMap(const PlanarMap&) = delete;
  PlanarMap& operator=(const PlanarMap&) = delete;
  virtual ~PlanarMap() = default;

  /// Replaces every point by its image under `iterates` steps; negative: of the inverse map. A point whose orbit cannot
  /// be followed (it leaves the domain, never returns to the section, the integration fails) becomes (NaN, NaN).
  /// Serial: callers hand out batches to threads.
  virtual void iterate(std::span<Point> points, int iterates) const = 0;

  /// The image of one point as `iterate` gives it (to the tolerance of an integration), and the derivative there.
  virtual Point iterate_with_derivative(Point point, int iterates, Matrix2& derivative) const = 0;
};

}  // namespace lober
