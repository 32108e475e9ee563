// Least periods of the points that Newton's method finds.
#pragma once

#include <span>
#include <vector>

#include "lober/dynamics/fixed_points.hpp"

namespace lober::detail {

/// The options for the points of each period that points of options.period may have, ascending, that itself last: it
/// divides, and makes whole turns.
[[nodiscard]] std::vector<FixedPointOptions> of_divisors(const FixedPointOptions& options);

/// The points of f^period(z) = z + shift at these places, by their least periods. A period that divides options.period
/// is theirs if it makes a whole number of turns. Near a bifurcation the equation for all of options.period is
/// degenerate, and Newton's method ends within the cube root of rounding of its points: those that are not further
/// than that from a point of a smaller period are this point.
[[nodiscard]] std::vector<FixedPoint> describe(const PlanarMap& map, std::span<const Point> at,
                                               const FixedPointOptions& options);

}  // namespace lober::detail
