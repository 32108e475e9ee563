// The saddle from which manifolds grow (private to manifolds/).
#pragma once

#include <string>

#include "lober/dynamics/planar_map.hpp"

namespace lober::detail {

/// `multiplier` and `tangent` are those of the unstable direction of F^steps.
struct Saddle {
  Point at;
  double multiplier;
  Point tangent;
};

/// The saddle of F^steps near a guess. Throws DataError when there is none, or when the map cannot be evaluated there.
[[nodiscard]] Saddle saddle_near(const PlanarMap& map, int steps, Point guess);

/// "; one iterate stretches by 2.7e+21 there, ...", where that explains why nothing is found; else nothing.
[[nodiscard]] std::string unresolved(double factor);

/// Compares the derivative that a system gives with differences of the map along both axes: everything that is made of
/// it is wrong where it is. Throws DataError.
void require_derivative_fits(const PlanarMap& map, int steps, Point at);

}  // namespace lober::detail
