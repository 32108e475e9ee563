// lober levels SYSTEM
#pragma once

#include <string>
#include <vector>

namespace lober::cli {

/// Throws UsageError, DataError, Cancelled.
void run_levels(const std::vector<std::string>& arguments);

}  // namespace lober::cli
