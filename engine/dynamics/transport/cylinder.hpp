// A plane that repeats itself, such as that of a lifted angle, as a plane on which every point of the cylinder occurs
// once.
//
// With s along the period and t across it, the point goes to the angle -2 pi s / period and to the radius
// sqrt(period (t + depth) / pi) about the origin: areas and orientations stay as they are, the lower end of the
// cylinder goes into the origin, and a curve from a saddle to its translate becomes a closed one. Nothing has to be
// summed over translates, because there are none.
#pragma once

#include <span>

#include "kernels/point.hpp"
#include "lober/curve.hpp"
#include "lober/local_manifold.hpp"
#include "lober/manifolds.hpp"
#include "lober/planar_map.hpp"

namespace lober::detail {

class Cylinder {
 public:
  /// The plane repeats itself after `period`; nothing lies lower than -depth across it.
  Cylinder(Point period, double depth);

  [[nodiscard]] Point wrap(Point plane) const;
  /// The point of the plane with 0 <= s < period.
  [[nodiscard]] Point unwrap(Point wrapped) const;

  /// How far a point lies across the period; wrap() needs more than -depth.
  [[nodiscard]] static double height(Point period, Point plane);

 private:
  Point along_;  // of length 1
  double length_, depth_;
};

/// A grown manifold on the cylinder: its vertices, and as many more points of the manifold, each computed as its
/// vertices are, as keep the polygon within `tolerance` of where straight segments of the plane go. Parallel.
[[nodiscard]] std::vector<Point> wrapped(const Cylinder& cylinder, const PlanarMap& map, const LocalManifold& local,
                                         const GrownManifold& grown, double tolerance);

}  // namespace lober::detail
