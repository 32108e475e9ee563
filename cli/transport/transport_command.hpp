#pragma once

#include <string>
#include <vector>

namespace lober::cli {

/// `lober transport ...`: `arguments` are those after the name of the command. Throws UsageError, DataError, Cancelled.
void run_transport(const std::vector<std::string>& arguments);

}  // namespace lober::cli
