// The help of commands, for `--help`.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "cli/program/command_description.hpp"

namespace lober::cli {

/// The reference of all commands, relative to the prefix of an installation; docs/reference.md in the sources.
inline constexpr std::string_view reference_page = "share/doc/lober/html/reference.html";

/// The section of a command in the reference: "lober-batch-run" of "lober batch run"; empty for other programs.
[[nodiscard]] std::string anchor_of(std::string_view command);

/// The end of a help text: where the reference has more, installed and in the sources.
[[nodiscard]] std::string reference_line(const std::string& anchor, std::size_t width);

/// The summary, the examples, the usage, and the options by group, in lines of at most `width` characters (those of
/// examples may be longer).
[[nodiscard]] std::string help_text(const CommandDescription& command, std::size_t width);

/// The examples, with a heading.
[[nodiscard]] std::string examples_text(const std::vector<CommandExample>& examples);

}  // namespace lober::cli
