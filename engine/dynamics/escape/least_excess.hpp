// How near to a saddle periodic orbits are found (private to escape/).
#pragma once

#include <cmath>

#include "lober/dynamics/periodic_orbit.hpp"

namespace lober::detail {

/// The least excess of an energy over that of the saddle: less is lost in rounding of the energy.
[[nodiscard]] inline double least_excess(const SaddlePoint& saddle) {
  return 1e-7 * (1 + std::fabs(saddle.energy));
}

}  // namespace lober::detail
