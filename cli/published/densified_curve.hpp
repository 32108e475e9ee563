// The points of a curve as the published program writes them: vertices, intersections, and those that -DENS
// inserts.
#pragma once

#include <vector>

#include "lober/interior.hpp"

namespace lober::cli {

/// -DENS <nPass> <nDens>: each pass puts nDens points, equally spaced, into every segment that holds an
/// intersection; the next pass does so in the parts that hold one. The distance to the nearest points falls
/// by nDens + 1 a pass.
struct Densification {
  int passes = 0;
  int points = 0;
};

struct LabelledPoint {
  Point point;
  Side side;  ///< with respect to the other curve
};

/// Curve `curve` (1 or 2) from its first vertex on, with the points where it meets the other one and the
/// inserted ones.
[[nodiscard]] std::vector<LabelledPoint> densified_curve(const Crossings& nodes, int curve,
                                                         Densification densification);

}  // namespace lober::cli
