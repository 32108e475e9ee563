// The paper's -DENS for the interior method: points where the label changes along a segment (private to interior/).
#pragma once

#include <vector>

#include "engine/interior/interior.hpp"

namespace lober {

struct LabelledCurve {
  std::vector<Point> points;
  std::vector<Side> labels;  ///< with respect to the other curve
};

/// The curve with `points` equally spaced points in every segment whose ends have different labels, then in those parts
/// of it whose ends have, and so on, `passes` times; each new point is labelled by a query. A change of label ends up
/// between neighbours (points + 1)^passes times closer than the ends of its segment. A segment that crosses the other
/// curve and comes back is not noticed, as in the paper. O(N + points inserted log N), parallel.
[[nodiscard]] LabelledCurve insert_points(const CurveView& curve, const Buffer<Side>& labels, const IndexedCurve& other,
                                          int passes, int points);

}  // namespace lober
