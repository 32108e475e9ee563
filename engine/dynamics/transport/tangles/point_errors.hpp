// What rounding and integration leave of the points of grown manifolds (private to engine/).
#pragma once

#include "kernels/box.hpp"
#include "lober/manifold_tangle.hpp"

namespace lober::detail {

/// How far points of a grown manifold that lie in the box are beside the manifold: the largest distance across the
/// curve of a sample of them from the same images computed more finely (PlanarMap::finer), twice, and a few roundings
/// of coordinates. Errors along the curve do not move it.
[[nodiscard]] double point_error(const PlanarMap& map, const LocalManifold& local, const GrownManifold& grown,
                                 const Box& box);

/// Adds what that makes of the areas of lobes and boundary to their errors: point_error times length.
void add_point_errors(ManifoldTangle& manifolds);

/// Lobes that reach out of where manifolds are as fine as asked (ManifoldTangle::fine) have no area to speak of: adds
/// an error of the whole area, and an infinite one where not even distances are true (ManifoldTangle::true_size).
void add_errors_far_outside(ManifoldTangle& manifolds);

}  // namespace lober::detail
