// A system at a glance: orbits, fixed points and manifolds, or the levels of the energy where it has no planar map.
#pragma once

#include <span>

#include "cli/picture/figure.hpp"
#include "lober/dynamics/fixed_points.hpp"
#include "lober/dynamics/systems.hpp"

namespace lober::cli {

/// The phase portrait of the system in its own window, with the points given. The work is bounded, to about a second on
/// one core; results are the same for any number of threads. Throws UsageError where there is nothing to draw.
[[nodiscard]] Figure system_portrait(const System& system, std::span<const FixedPoint> points, bool labels);

}  // namespace lober::cli
