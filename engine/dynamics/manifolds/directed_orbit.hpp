// Connecting orbits with the direction in which the manifolds cross (private to engine/).
#pragma once

#include "lober/dynamics/connecting_orbit.hpp"

namespace lober::detail {

struct DirectedOrbit {
  ConnectingOrbit orbit;
  bool to_left = false;  ///< whether S crosses U from right to left, both run through as their parameters grow
};

/// As connecting_orbit.
[[nodiscard]] DirectedOrbit directed_orbit(const PlanarMap& map, const LocalManifold& unstable,
                                           const LocalManifold& stable, ManifoldPosition u, ManifoldPosition s);

}  // namespace lober::detail
