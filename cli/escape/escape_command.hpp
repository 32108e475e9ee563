#pragma once

#include <string>
#include <vector>

namespace lober::cli {

/// `lober escape ...`: `arguments` are those after the name of the command. Throws UsageError, DataError, Cancelled.
void run_escape(const std::vector<std::string>& arguments);

}  // namespace lober::cli
