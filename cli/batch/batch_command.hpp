// `lober batch`.
#pragma once

#include <string>
#include <vector>

namespace lober::cli {

/// Runs `lober batch run|check|status|export|merge` with the arguments that follow `batch`. Throws UsageError,
/// DataError, Cancelled.
void run_batch_command(const std::vector<std::string>& arguments);

}  // namespace lober::cli
