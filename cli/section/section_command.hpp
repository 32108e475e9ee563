#pragma once

#include <string>
#include <vector>

namespace lober::cli {

/// `lober section ...`: `arguments` are those after the name of the command. Throws UsageError, DataError, Cancelled.
void run_section(const std::vector<std::string>& arguments);

}  // namespace lober::cli
