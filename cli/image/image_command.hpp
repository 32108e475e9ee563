#pragma once

#include <string>
#include <vector>

namespace lober::cli {

/// `lober image ...`: `arguments` are those after the name of the command. Throws UsageError, DataError,
/// DisagreementError, Cancelled.
void run_image(const std::vector<std::string>& arguments);

}  // namespace lober::cli
