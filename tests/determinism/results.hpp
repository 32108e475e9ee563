// Everything that a computation returns, as one number (times and counts of work apart, which may differ).
#pragma once

#include <cstdint>

#include "engine/geometry/index/index.hpp"
#include "lober/curve/curve.hpp"

namespace lober::detail {

/// Areas, bounds, nodes, classes, pieces, centroids, slivers and discretisation of the overlay.
[[nodiscard]] std::uint64_t overlay_hash(CurveView c1, CurveView c2, IndexKind index);
/// Areas, nodes and labels by the interior function, and windings and J at some points.
[[nodiscard]] std::uint64_t interior_hash(CurveView c1, CurveView c2, IndexKind index);
/// Table, areas and pieces of the regions.
[[nodiscard]] std::uint64_t regions_hash(CurveView c1, CurveView c2, IndexKind index);
/// Nodes, pips, lobes, boundary, images, overlaps and shapes of the tangle, of polygons and of smooth curves.
[[nodiscard]] std::uint64_t tangle_hash(CurveView u, CurveView s, IndexKind index);
/// The first curve made finer everywhere and near the second one, both with their crossings, and made coarser.
[[nodiscard]] std::uint64_t densify_hash(CurveView c1, CurveView c2);

}  // namespace lober::detail
