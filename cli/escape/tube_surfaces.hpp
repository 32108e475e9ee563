// The surfaces of tubes, for other programs and for the picture.
#pragma once

#include <vector>

#include "cli/escape/escape_report.hpp"
#include "lober/dynamics/tube_surface.hpp"

namespace lober::cli {

struct Surface {
  TubeSurface tube;
  bool entry;  ///< whether the manifold is unstable
};

struct Position3 {
  double x, y, z;
};
/// The coordinate across the section, and both of its chart.
[[nodiscard]] Position3 position_of(const FlowState& state, const Section& section);

/// The tubes that were chosen. Throws DataError when there is none.
[[nodiscard]] std::vector<Surface> surfaces_of(const Flow& flow, const EscapeReport& report, std::size_t around,
                                               std::size_t rings_a_period);

/// The states at equal steps of time of the trajectory from a point of the section: until it has left by a bottleneck,
/// or is back on the section. Throws DataError for a point that the energy does not reach.
[[nodiscard]] std::vector<FlowState> trajectory_from(const EscapeReport& report, Point start);

/// The picture of surfaces and trajectories, seen from ahead, from the right and from above.
[[nodiscard]] Figure tubes_figure(const Flow& flow, const EscapeReport& report);

}  // namespace lober::cli
