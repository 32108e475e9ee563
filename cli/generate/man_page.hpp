// Manual pages of the program and its commands.
#pragma once

#include <string>
#include <string_view>

namespace lober::cli {

/// lober(1): all commands with the names of their options.
[[nodiscard]] std::string program_man_page();
/// lober-overlay(1) of "overlay". Throws UsageError for a name that is not that of a command.
[[nodiscard]] std::string command_man_page(std::string_view name);

}  // namespace lober::cli
