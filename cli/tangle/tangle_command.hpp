#pragma once

#include <string>
#include <vector>

namespace lober::cli {

/// `lober tangle ...`: `arguments` are those after the name of the command. Throws UsageError, DataError,
/// Cancelled.
void run_tangle(const std::vector<std::string>& arguments);

}  // namespace lober::cli
