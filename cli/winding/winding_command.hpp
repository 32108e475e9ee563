#pragma once

#include <string>
#include <vector>

namespace lober::cli {

/// `lober winding ...`: `arguments` are those after the name of the command. Throws UsageError, DataError,
/// DisagreementError, Cancelled.
void run_winding(const std::vector<std::string>& arguments);

}  // namespace lober::cli
