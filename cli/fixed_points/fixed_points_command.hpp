#pragma once

#include <string>
#include <vector>

namespace lober::cli {

/// `lober fixed-points ...`: `arguments` are those after the name of the command. Throws UsageError, DataError,
/// Cancelled.
void run_fixed_points(const std::vector<std::string>& arguments);

}  // namespace lober::cli
