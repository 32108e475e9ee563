// Programs that run while the test goes on.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace lober::cli {

using Seconds = std::chrono::duration<double>;

/// Starts command[0], looked up in PATH, in this folder; its output goes nowhere.
[[nodiscard]] pid_t start_in(const std::filesystem::path& folder, const std::vector<std::string>& command);

/// Its exit status; -1 if a signal ended it.
int wait_for(pid_t process);

}  // namespace lober::cli
