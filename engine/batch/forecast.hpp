// The work of a plan that will not fit into memory, as far as that can be seen without doing it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/batch/manifest/plan.hpp"

namespace lober::detail {

/// A line for each curve that would be computed and each group of jobs whose results would take more than so many
/// bytes. Curves are computed for the first few iterates, with few points, and taken to go on growing as they did in
/// the last one; results are forecast for the first curve of a group that is not too large to be read in passing. What
/// cannot be read or computed is left to the jobs. Some seconds at most.
[[nodiscard]] std::vector<std::string> forecast_shortage(const Plan& plan, const std::string& manifest_path,
                                                         std::size_t memory);

}  // namespace lober::detail
