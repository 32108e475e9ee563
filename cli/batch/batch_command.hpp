// `lober batch`.
#pragma once

#include <string>
#include <vector>

namespace lober::cli {

/// Runs `lober batch run|check|status|export|merge|manifest|operations` with the arguments that follow `batch`. Throws
/// UsageError, DataError, Cancelled.
void run_batch_command(const std::vector<std::string>& arguments);

/// The names of the subcommands.
[[nodiscard]] std::vector<std::string> batch_verbs();

}  // namespace lober::cli
