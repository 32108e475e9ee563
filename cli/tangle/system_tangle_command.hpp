#pragma once

#include <string>
#include <vector>

namespace lober::cli {

/// Whether these arguments of `lober tangle` name a system rather than files.
[[nodiscard]] bool names_system(const std::vector<std::string>& arguments);

/// `lober tangle --system ...`: `arguments` are those after the name of the command. Throws UsageError, DataError,
/// Cancelled.
void run_system_tangle(const std::vector<std::string>& arguments);

}  // namespace lober::cli
