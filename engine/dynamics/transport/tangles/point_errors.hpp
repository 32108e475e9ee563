// Errors of the points of grown manifolds by rounding and integration (private to engine/).
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "kernels/box.hpp"
#include "lober/tangle/manifold_tangle.hpp"

namespace lober::detail {

/// How far points of a grown manifold that lie in the box are beside the manifold: the largest distance across the
/// curve of a sample of them from the same images computed more finely (PlanarMap::finer), twice, and a few roundings
/// of coordinates. Errors along the curve do not move it.
class PointErrors {
 public:
  /// Samples the vertices up to `middle` and those from there to `last`.
  PointErrors(const PlanarMap& map, const LocalManifold& local, const GrownManifold& grown, std::size_t middle,
              std::size_t last, const Box& box);
  /// The error of the vertices up to this one: those farther out, where orbits are longer and folds sharper, do not
  /// count.
  [[nodiscard]] double up_to(std::size_t vertex) const;

 private:
  double rounding_ = 0;
  std::vector<std::pair<std::size_t, double>> up_to_;  // vertices, and the largest distance up to each
};

/// Fills in the errors of points up to each pip, and adds what they make of the areas of lobes and boundary to those of
/// `tangle`: error times length.
void add_point_errors(const PlanarMap& map, const Box& box, ManifoldTangle& manifolds);

/// Lobes that reach out of where manifolds are as fine as asked (ManifoldTangle::fine) have no area to speak of: adds
/// an error of the whole area, and an infinite one where not even distances are true (ManifoldTangle::true_size).
void add_errors_far_outside(ManifoldTangle& manifolds);

}  // namespace lober::detail
