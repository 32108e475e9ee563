// Options of operations that grow the manifolds of a tangle (private to operations/).
#pragma once

#include "engine/operations/option_list.hpp"

namespace lober::detail::table {

/// Work that growing a manifold or following images may take unasked: 9 s (duffing) to 63 s (abc) were measured on two
/// cores.
inline constexpr double unasked_work = 1e9;

/// How::max_work, which is unasked_work where nothing is given.
template <typename How>
OptionList<How>& add_work_option(OptionList<How>& list) {
  return list.option("max_work", &How::max_work,
                     "maximum work, in evaluations of the vector field, or in steps of a map that is given by formulas",
                     {.min = 0, .above_min = true, .value = "N"});
}

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
