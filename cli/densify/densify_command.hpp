#pragma once

#include <string>
#include <vector>

namespace lober::cli {

/// `lober densify ...`: `arguments` are those after the name of the command. Throws UsageError, DataError,
/// Cancelled.
void run_densify(const std::vector<std::string>& arguments);

}  // namespace lober::cli
