// Results that the program wrote as JSON: they name their inputs and options, and hold no points, so their pages come
// from the same computation, done again.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace lober::cli {

struct RepeatedResult {
  std::string command;                 ///< "overlay"
  std::vector<std::string> arguments;  ///< inputs and options of the run that wrote it
};

/// The run that wrote a result; nothing for a file that is not one. A result may come from anybody: no library is
/// loaded but `library`, which the user names, if any, and which a result of such a system needs. Throws DataError for
/// a result that cannot be repeated: of another command, of options that are not known, or of inputs that have changed
/// since; UsageError where `library` is missing, not needed, or has another system.
[[nodiscard]] std::optional<RepeatedResult> repeated_result(const std::string& path, const std::string& library);

}  // namespace lober::cli
