// The commands of the program: those with a folder of their own here, and the operations of the table.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "cli/program/command_description.hpp"

namespace lober::cli {

/// The headings of the list of commands, in their order.
enum class CommandGroup : std::uint8_t { curves, systems, many, program };

struct Command {
  std::string name;   ///< "overlay"
  std::string call;   ///< "C1 C2 [options]"
  std::string title;  ///< a phrase with a verb: "computes crossings, lobes and areas of two closed curves"
  CommandGroup group = CommandGroup::curves;
};

/// All of them, by group.
[[nodiscard]] std::vector<Command> all_commands();
[[nodiscard]] std::vector<std::string> command_names();
[[nodiscard]] const char* title_of(CommandGroup group);

[[nodiscard]] bool is_command(std::string_view name);
/// Runs it. Throws as commands do. The name has to be that of a command.
void run_command(std::string_view name, const std::vector<std::string>& arguments);

/// The forms of a command, each with options of its own: tangle of files, and tangle of a system; batch run, batch
/// check, and so on.
[[nodiscard]] std::vector<CommandDescription> forms_of(const Command& command);

}  // namespace lober::cli
