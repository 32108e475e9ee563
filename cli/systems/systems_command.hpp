#pragma once

#include <string>
#include <vector>

namespace lober::cli {

/// `lober systems ...`: `arguments` are those after the name of the command. Throws UsageError, DataError.
void run_systems(const std::vector<std::string>& arguments);

}  // namespace lober::cli
