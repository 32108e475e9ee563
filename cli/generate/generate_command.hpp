// `lober --generate`: manual pages and completions, which packages install.
#pragma once

#include <string>
#include <vector>

namespace lober::cli {

/// Runs `lober --generate man [COMMAND]|complete-bash|complete-zsh|complete-fish|markdown|commands`, with the arguments
/// from "--generate" on. Throws UsageError.
void run_generate(const std::vector<std::string>& arguments);

}  // namespace lober::cli
