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

/// Seconds that all pilots may take together.
struct PilotLimits {
  double processor = 3;  ///< time of the processor after which no further one begins
  double clock = 10;     ///< time after which one that runs is broken off: a busy machine lets it run on
};

/// Runs pilots of some jobs, evenly spread over all of these, as many as the limits allow but one at least; the others
/// count as the nearest of them in the plan, where members of a grid stand in order. Measured by processor time, on one
/// thread. Throws Cancelled when the caller was.
[[nodiscard]] Piloted run_pilots(const Plan& plan, PilotLimits limits = {});

}  // namespace lober::detail
