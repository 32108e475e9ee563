// Lines with fewer points that look the same.
#pragma once

#include <span>
#include <vector>

#include "cli/report/svg.hpp"

namespace lober::cli {

/// Some of the points of a line, first and last among them, such that the others lie no further than sqrt(2) times
/// `tolerance` from the line through those (sideways no further than `tolerance`). O(N), in one pass: from each point
/// kept goes the cone of directions in which the line past all later points may go on.
[[nodiscard]] std::vector<Pixel> thinned(std::span<const Pixel> line, double tolerance);

}  // namespace lober::cli
