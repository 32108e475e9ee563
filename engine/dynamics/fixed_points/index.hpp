// How often the displacement f^period(z) - z - shift turns round along a closed path.
#pragma once

#include <optional>

#include "engine/dynamics/fixed_points/scan.hpp"
#include "lober/dynamics/fixed_points.hpp"

namespace lober::detail {

/// Along the edge of the box: the sum of the indices of the points in it. None where that takes more than a quarter of
/// the work, or a point next to the edge leaves the direction open. `an_image`: the work that an image takes.
[[nodiscard]] std::optional<int> index_of_edge(const PlanarMap& map, const Rectangle& box,
                                               const FixedPointOptions& options, double an_image,
                                               const SearchAllowance& allowance);

/// Along the smallest of some circles about a degenerate point on which no displacement is rounding, and that have a
/// radius of at most `most`. None where there is none.
[[nodiscard]] std::optional<int> index_around(const PlanarMap& map, Point centre, double most,
                                              const FixedPointOptions& options);

}  // namespace lober::detail
