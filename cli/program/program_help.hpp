// `lober --help`: the list of commands.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cli/program/command_description.hpp"

namespace lober::cli {

/// The sentence that says what the program is for.
inline constexpr const char* program_summary =
    "lober: exact crossings, lobes and areas of curves for phase-space transport";

/// Two command lines to begin with.
[[nodiscard]] std::vector<CommandExample> program_examples();

/// Command lines of the program itself, beside the commands: "--version [--verbose]", and what they do.
[[nodiscard]] std::vector<CommandExample> program_calls();
/// Command lines of Lober 1.8, and what they do.
[[nodiscard]] std::vector<CommandExample> published_calls();

/// How curves are named on the command line.
[[nodiscard]] std::string curve_paragraph();
/// Each exit status with its meaning.
[[nodiscard]] std::vector<CommandExample> exit_statuses();

[[nodiscard]] std::string program_help(std::size_t width);

}  // namespace lober::cli
