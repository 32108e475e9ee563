// Jobs whose time is not known from their options are judged by shorter ones, pilots, that are run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/batch/manifest/plan.hpp"

namespace lober::detail {

/// The times of jobs by pilots.
struct Piloted {
  std::vector<std::uint32_t> jobs;  ///< those whose operation has pilots
  std::vector<double> seconds;      ///< time of each of them on one core
  std::size_t run = 0;              ///< number of pilots
};

/// Runs pilots of some jobs, evenly spread over all of these, as many as fit into some seconds; the others count as the
/// nearest of them in the plan, where members of a grid stand in order. Measured by processor time, on one thread.
/// Throws Cancelled when the caller was.
[[nodiscard]] Piloted run_pilots(const Plan& plan);

}  // namespace lober::detail
