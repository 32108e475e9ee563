// The table of escape by counting trajectories: a check that shares only the first curves E and X with the table.
#pragma once

#include <cstdint>
#include <vector>

#include "lober/base/export.hpp"
#include "lober/base/progress.hpp"
#include "lober/transport/escape.hpp"

namespace lober {

/// Options of monte_carlo.
struct MonteCarloOptions {
  std::uint64_t trajectories = 1'000'000;                              ///< from each entry
  std::uint64_t seed = 1;                                              ///< seed of the random numbers
  IntegrationOptions integration{.tolerance = 1e-9, .max_time = 200};  ///< how trajectories are integrated
  Progress progress{};                                                 ///< called with the fraction done
};

/// The count for one row of Escape::table.
struct MonteCarloFraction {
  std::uint64_t count = 0;    ///< number of trajectories that left so
  double fraction = 0;        ///< their part of all
  double standard_error = 0;  ///< sqrt(F (1 - F) / N), F from the table where it is known, else the fraction counted
};

/// The result of monte_carlo.
struct MonteCarlo {
  std::vector<MonteCarloFraction> table;  ///< row by row as Escape::table
  std::uint64_t trajectories = 0;         ///< number of trajectories from each entry
  std::uint64_t lost = 0;                 ///< neither inside an exit nor followed to the next crossing
  double largest_deviation = 0;           ///< max |counted - table| in standard errors
};

/// The fractions of the table and those counted. A bar allows five standard errors, and for rare fractions the effect
/// of a handful of trajectories more or less, so that among a hundred rows none is off by chance in a million tables.
LOBER_API void compare(const Escape& result, const MonteCarlo& counted, Agreement& agreement);

/// Points evenly distributed in each E, followed crossing by crossing until they lie in an X or n exceeds that of the
/// table. Point k depends on the seed and k alone (a hash of both), and so does the result, for any number of threads.
[[nodiscard]] LOBER_API MonteCarlo monte_carlo(const Flow& flow, const Escape& result,
                                               const MonteCarloOptions& options);

}  // namespace lober
