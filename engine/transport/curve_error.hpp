// How far computed manifolds may lie from the true ones.
#pragma once

#include "engine/transport/manifold_tangle.hpp"

namespace lober {

/// An estimate, on the safe side, of the distance between the vertices of both manifolds and the true manifolds, up to
/// the bip: what the integration and rounding err by in a step, measured across the curves by going a step back and
/// forth from 64 vertices of either, summed over steps (errors across shrink by the multiplier with each), and the
/// defect of the local manifolds. In units of the coordinates.
[[nodiscard]] double curve_error(const PlanarMap& map, const ManifoldTangle& manifolds);

}  // namespace lober
