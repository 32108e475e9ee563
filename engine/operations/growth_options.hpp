// Options of operations that grow the manifolds of a tangle (private to operations/).
#pragma once

#include "engine/operations/describe.hpp"

namespace lober::detail::table {

/// How::tolerance and How::max_points, as in ManifoldTangleOptions.
template <typename How>
OptionList<How>& add_growth_options(OptionList<How>& list) {
  return list
      .option(
          "tolerance", &How::tolerance,
          "maximum distance between a manifold and its polygon, in units of the coordinates; errors of areas are far "
          "smaller",
          {.min = 0, .above_min = true, .value = "D"})
      .option("max_points", &How::max_points, "maximum number of points of each manifold",
              {.min = 2, .max = 2147483646, .value = "N"});
}

}  // namespace lober::detail::table
