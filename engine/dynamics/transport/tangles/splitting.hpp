// The distance of two manifolds along one fundamental segment of a tangle (private to engine/).
//
// Where U and S run side by side, S is the graph of a function over U: at the time t along U its distance d(t) from U,
// along the normal of U. The tangle is thin where d is small; its zeros are the pips, as many in one iterate as the
// map has pips a period. d is computed from both manifolds' own parameters, not from polygons, so that it tells
// a splitting of 1e-13 from none where polygons of any tolerance cross at random.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "lober/dynamics/connecting_orbit.hpp"

namespace lober::detail {

struct Splitting {
  /// The smallest over the lobes of one iterate of the largest |d| on that lobe; without a zero the largest |d| of all.
  double amplitude = 0;
  double largest = 0;     ///< |d| anywhere
  double noise = 0;       ///< noise of d by rounding and integration, from the roughness of its values
  double defect = 0;      ///< defect of the local manifolds: the error that d may have everywhere
  std::size_t zeros = 0;  ///< sign changes of d within one iterate
  /// Near the zeros, on U and on S, outward along U.
  std::vector<std::pair<ManifoldPosition, ManifoldPosition>> near_zeros;

  /// Whether d is no more than noise or the defect: the manifolds coincide as far as can be seen.
  [[nodiscard]] bool coincide() const {
    return !(largest > 12 * noise && largest > (zeros == 0 ? 4 * defect : defect));
  }
};

/// The splitting on one iterate of U about the position `u`, where S is at the position `s`. Nothing where S is not a
/// graph over U there, as is usual when it is large. About a thousand steps of the map, with derivatives.
[[nodiscard]] std::optional<Splitting> splitting(const PlanarMap& map, const LocalManifold& unstable,
                                                 const LocalManifold& stable, ManifoldPosition u, ManifoldPosition s);

/// Time along a manifold, in its images: 0 at the end of the local manifold.
[[nodiscard]] double time_of(const LocalManifold& local, ManifoldPosition position);
/// The position at a time, in the outermost fundamental segment unless the time is negative.
[[nodiscard]] ManifoldPosition position_at(const LocalManifold& local, double time, double side);

}  // namespace lober::detail
