// Points beside each other in a valley of the displacement, as those of a thin resonance are.
#pragma once

#include <span>
#include <vector>

#include "lober/dynamics/fixed_points.hpp"

namespace lober::detail {

/// Guesses of the points of options.period beside those of them where D - 1 moves points in one direction so much less
/// than across it that Newton's method hardly gets along: both ways along the valley of each, until that leaves the
/// box, ends or closes, where the displacement, which is zero across its floor, changes sign. A valley is gone along
/// once. Some 32 steps a period and width of the box, and more where it bends, each of which takes a few derivatives.
[[nodiscard]] std::vector<Point> guesses_in_valleys(const PlanarMap& map, std::span<const FixedPoint> points,
                                                    const Rectangle& box, const FixedPointOptions& options);

}  // namespace lober::detail
