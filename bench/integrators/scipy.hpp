// SciPy's solve_ivp with DOP853, in a program of its own.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace lober::bench {

struct ScipyRun {
  double tolerance, nanoseconds;    ///< a point
  std::vector<double> coordinates;  ///< of all ends, one point after the other
};

/// Empty if there is no python3 with SciPy. `coordinates`: those of all points, `dimension` for each.
[[nodiscard]] std::vector<ScipyRun> run_scipy(const std::string& system, double span,
                                              std::span<const double> coordinates, std::size_t dimension,
                                              std::span<const double> tolerances);

}  // namespace lober::bench
