// The tangle of a boundary as curves on a cylinder (private to transport/).
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "engine/dynamics/transport/barrier.hpp"
#include "engine/dynamics/transport/cylinder.hpp"
#include "lober/manifold_tangle.hpp"
#include "lober/planar_map.hpp"

namespace lober::detail {

struct WrappedTangle {
  std::vector<Point> u, s;
  std::unique_ptr<Tangle> tangle;  ///< of u and s
  bool has_all_crossings = false;  ///< finer polygons have as many
};

/// Deep enough for all that was grown. O(points).
[[nodiscard]] Cylinder cylinder_of(Point lattice, std::span<const ManifoldTangle* const> tangles);

/// As fine as it takes for the polygons to have the pips from f^-before(q) to f^after(q) that the manifolds have in the
/// plane, and, as far as `allowance` evaluations of the map (PlanarMap::work) go, so fine that polygons ten times finer
/// have as many crossings. Throws DataError where manifolds of neighbouring cells cross between those pips.
[[nodiscard]] WrappedTangle wrapped_tangle(const Cylinder& cylinder, const PlanarMap& map,
                                           const ManifoldTangle& manifolds, int before, int after, double allowance);

/// The boundary of a tangle in the plane; the tangle must outlive it.
[[nodiscard]] Barrier barrier_of(const ManifoldTangle& manifolds);
/// The same boundary on the cylinder; both must outlive it.
[[nodiscard]] Barrier barrier_of(const ManifoldTangle& manifolds, const WrappedTangle& wrapped);

}  // namespace lober::detail
