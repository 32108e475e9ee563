// Options of operations that grow the manifolds of a tangle (private to operations/).
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "engine/operations/option_list.hpp"
#include "lober/dynamics/systems.hpp"

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

/// How::tolerance_given, for tolerance_in.
template <typename How>
OptionList<How>& add_tolerance_option(OptionList<How>& list, std::string meaning) {
  return list.option("tolerance", &How::tolerance_given, std::move(meaning) + ", in units of the coordinates",
                     {.min = 0,
                      .above_min = true,
                      .otherwise = "1e-5 times the power of ten in the extent of the system's window: 1e-5 for the "
                                   "built-in systems",
                      .value = "LENGTH"});
}

/// The tolerance given, or one for curves in the window of a system, which knows the unit of its coordinates.
[[nodiscard]] double tolerance_in(const System& system, std::optional<double> given);

/// How::tolerance_given and How::max_points, as in ManifoldTangleOptions.
template <typename How>
OptionList<How>& add_growth_options(OptionList<How>& list) {
  return add_tolerance_option(
             list, "maximum distance between a manifold and its polygon, which errors of areas are far smaller than")
      .option("max_points", &How::max_points, "maximum number of points of each manifold",
              {.min = 2, .max = 2147483646, .value = "N"});
}

}  // namespace lober::detail::table
