// Completions for shells, made from the commands as their parsers declare them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/program/command_description.hpp"

namespace lober::cli {

/// A command, or a subcommand of batch, with the options of all its forms.
struct CompletedCommand {
  std::vector<std::string> words;  ///< "batch", "run"
  std::string title;
  std::vector<OptionDescription> arguments, options;  ///< each once
  bool has_one_form = true;                           ///< arguments are in their order
};

[[nodiscard]] std::vector<CompletedCommand> completed_commands();

/// Words that follow `lober --generate`, with meanings.
[[nodiscard]] std::vector<CommandExample> kinds_of_pages();

/// The first sentence without what is in brackets or behind a semicolon: "Write the results to FILE".
[[nodiscard]] std::string short_meaning(const OptionDescription& option);

/// A script for the shell.
[[nodiscard]] std::string bash_completion();
[[nodiscard]] std::string zsh_completion();
[[nodiscard]] std::string fish_completion();

}  // namespace lober::cli
