// Where the energy of a flow ends on a section.
#pragma once

#include <vector>

#include "lober/curve/point.hpp"
#include "lober/dynamics/flow.hpp"
#include "lober/dynamics/levels.hpp"

namespace lober::detail {

/// The curves in a window of a section's chart beyond which the section has no points of this energy: there the least
/// energy over the coordinate that the section solves for is the energy, and trajectories are tangent to the section.
/// The part that the section's bound excludes is left out. None for a section that solves for no coordinate (flows of
/// three dimensions). The Hamiltonian has to be quadratic in that coordinate. O(cells of a grid of 240 x 240).
[[nodiscard]] std::vector<LevelCurve> section_edge(const Flow& flow, const Section& section, double energy,
                                                   const Rectangle& window);

}  // namespace lober::detail
