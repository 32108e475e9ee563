// The surface of a tube between its periodic orbit and a section, for pictures in three dimensions.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "lober/base/export.hpp"
#include "lober/curve/point.hpp"
#include "lober/dynamics/flow.hpp"
#include "lober/dynamics/periodic_orbit.hpp"

namespace lober {

/// Closed rings of states at equal steps of time, from the section to where the tube has closed in on its orbit.
struct TubeSurface {
  std::size_t around = 0;         ///< states of a ring; they follow each other round it
  std::vector<FlowState> states;  ///< ring by ring, the one on the section first
  /// Number of rings.
  [[nodiscard]] std::size_t rings() const { return around == 0 ? 0 : states.size() / around; }
};

/// Options of tube_surface.
struct TubeSurfaceOptions {
  std::size_t around = 48;           ///< states of a ring
  std::size_t rings_a_period = 24;   ///< rings for each period of the orbit
  std::size_t max_rings = 400;       ///< rings at most
  IntegrationOptions integration{};  ///< how trajectories are integrated
};

/// Carries the curve in which a tube meets a section for the first time, in the chart of the section, back to the orbit
/// (`backward`: for an unstable tube) or on to it. The section's direction is that in which the tube crosses it. A ring
/// that loses a state is the last but one. Errors of the curve grow by the orbit's multiplier a period: good for
/// pictures, not for numbers. Throws UsageError for a curve of fewer than three points.
[[nodiscard]] LOBER_API TubeSurface tube_surface(const Flow& flow, const Section& section, double energy,
                                                 std::span<const Point> curve, const PeriodicOrbit& orbit,
                                                 bool backward, const TubeSurfaceOptions& options = {});

}  // namespace lober
