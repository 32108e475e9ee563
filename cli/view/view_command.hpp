#pragma once

#include <string>
#include <vector>

namespace lober::cli {

/// `lober view ...`: `arguments` are those after the name of the command. Throws UsageError, DataError, Cancelled.
void run_view(const std::vector<std::string>& arguments);

}  // namespace lober::cli
