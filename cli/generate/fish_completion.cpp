#include <spdlog/fmt/fmt.h>

#include "cli/generate/completions.hpp"
#include "cli/program/commands.hpp"
#include "lober/dynamics/systems.hpp"
#include "lober/operations.hpp"

namespace lober::cli {
namespace {

std::string fish_quoted(std::string_view text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "'";
}

// -x: one value and no files; -r -F: a value, which is a file.
std::string fish_values(const OptionDescription& option) {
  switch (option.kind) {
    case ValueKind::choice:
      return " -x -a " + fish_quoted(fmt::format("{}", fmt::join(option.choices, " ")));
    case ValueKind::file:
      return " -r -F";
    case ValueKind::folder:
      return " -x -a '(__fish_complete_directories)'";
    case ValueKind::system:
      return " -r -F -a '(__lober_systems)'";
    case ValueKind::parameter:
      return " -x -a '(__lober_parameters)'";
    case ValueKind::operation:
      return " -x -a '(__lober_operations)'";
    case ValueKind::other:
      return " -x";
    case ValueKind::none:
      break;
  }
  return "";
}

std::string fish_command(const CompletedCommand& command) {
  const std::string begin = fmt::format("complete -c lober -n '__lober_using {}'", fmt::join(command.words, " "));
  std::string text;
  bool files = false, systems = false, operation_names = false;
  for (const OptionDescription& argument : command.arguments) {
    files = files || argument.kind == ValueKind::file || argument.kind == ValueKind::system;
    systems = systems || argument.kind == ValueKind::system;
    operation_names = operation_names || argument.kind == ValueKind::operation;
  }
  if (files) text += begin + " -F\n";
  if (systems) text += begin + " -a '(__lober_systems)'\n";
  if (operation_names) text += begin + " -a '(__lober_operations)'\n";
  for (const OptionDescription& option : command.options) {
    text += begin;
    for (const std::string& name : option.names) {
      text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    }
    text += fish_values(option) + " -d " + fish_quoted(short_meaning(option)) + "\n";
  }
  return text + "\n";
}

// A function that prints words and their meanings, a tab between.
std::string fish_words(const std::string& name, const std::vector<CommandExample>& words) {
  std::string text = "function __lober_" + name + "\n";
  for (const CommandExample& word : words) {
    text += "    printf '%s\\t%s\\n' " + fish_quoted(word.line) + " " + fish_quoted(word.meaning) + "\n";
  }
  return text + "end\n\n";
}

std::string fish_parameters() {
  std::string text = "function __lober_parameters\n    for word in (commandline -opc)\n        switch $word\n";
  for (const SystemInfo& info : list_systems()) {
    text += "            case " + info.name + "\n";
    for (const Parameter& parameter : info.parameters) {
      text += "                printf '%s\\t%s\\n' " + fish_quoted(parameter.name + "=") + " " +
              fish_quoted(parameter.meaning) + "\n";
    }
  }
  return text + "        end\n    end\nend\n\n";
}

}  // namespace

std::string fish_completion() {
  std::vector<CommandExample> systems, operation_names;
  for (const SystemInfo& info : list_systems()) systems.push_back({info.name, info.summary});
  for (const operations::Operation& operation : operations::all()) {
    operation_names.push_back({operation.name, operation.title});
  }
  std::string text = R"(# Completions of lober for fish: `lober --generate complete-fish` prints them.

# Whether the words behind lober begin with these.
function __lober_using
    set -l words (commandline -opc)
    set -e words[1]
    test (count $words) -ge (count $argv); or return 1
    for k in (seq (count $argv))
        test "$words[$k]" = "$argv[$k]"; or return 1
    end
end

# Whether the words behind lober are these.
function __lober_at
    test (count (commandline -opc)) -eq (math (count $argv) + 1); and __lober_using $argv
end

)";
  text += fish_words("systems", systems) + fish_words("operations", operation_names) + fish_parameters();
  text += "complete -c lober -f\n";
  const std::string first = "complete -c lober -n __lober_at";
  text += first + " -F\n";  // the command lines of Lober 1.8 begin with a file
  for (const Command& command : all_commands()) {
    text += first + " -a " + command.name + " -d " + fish_quoted(command.title) + "\n";
  }
  text += first + " -a help -d 'lists the options of a command'\n";
  text += first + " -l help -d 'Print the list of commands and exit'\n";
  text += first + " -l version -d 'Print the version and exit'\n";
  text += first + " -l generate -x -d 'Print a manual page or completions' -a '";
  for (const CommandExample& kind : kinds_of_pages()) text += kind.line + " ";
  text.back() = '\'';
  text += "\ncomplete -c lober -n '__lober_at help' -a '";
  for (const std::string& name : command_names()) text += name + " ";
  text.back() = '\'';
  text += "\n\n";
  const std::vector<CompletedCommand> commands = completed_commands();
  for (const CompletedCommand& command : commands) {
    if (command.words.size() != 2) continue;
    text += "complete -c lober -n '__lober_at " + command.words[0] + "' -a " + command.words[1] + " -d " +
            fish_quoted(command.title) + "\n";
  }
  text += "\n";
  for (const CompletedCommand& command : commands) text += fish_command(command);
  return text;
}

}  // namespace lober::cli
