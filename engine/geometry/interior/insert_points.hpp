// -DENS of Naik, Lekien & Ross (2017) for the interior method: points where the label changes along a segment (private
// to interior/).
#pragma once

#include <span>
#include <vector>

#include "lober/overlay/interior.hpp"

namespace lober::detail {

struct LabelledCurve {
  std::vector<Point> points;
  std::vector<Side> labels;  ///< with respect to the other curve
};

/// The curve with `points` equally spaced points in every segment whose ends have different labels, then in those parts
/// of it whose ends have, and so on, `passes` times. A new point has the label of its position on the segment, which is
/// known from where the curves meet, not that of its rounded coordinates, which on an arc that both curves share are
/// beside it, now here, now there. A change of label ends up between neighbours (points + 1)^passes times closer than
/// the ends of its segment. A segment that crosses the other curve and comes back is not noticed, as in the article.
/// `changes`: the side_changes of the curve. Throws DataError when the curve would have more than `max_points` points.
/// O(N + points inserted log of the changes on a segment), parallel.
[[nodiscard]] LabelledCurve insert_points(const CurveView& curve, const Buffer<Side>& labels,
                                          std::span<const SideChange> changes, int passes, int points,
                                          std::size_t max_points);

}  // namespace lober::detail
