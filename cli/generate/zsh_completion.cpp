#include <spdlog/fmt/fmt.h>

#include "cli/generate/completions.hpp"
#include "cli/program/commands.hpp"
#include "lober/dynamics/systems.hpp"
#include "lober/operations.hpp"

namespace lober::cli {
namespace {

// Between single quotes of the shell, with the characters escaped that _arguments and _describe give a meaning.
std::string zsh_escaped(std::string_view text, std::string_view special) {
  std::string escaped;
  for (const char c : text) {
    if (special.find(c) != std::string_view::npos) escaped += '\\';
    escaped += c == '\'' ? "'\\''" : std::string(1, c);
  }
  return escaped;
}

std::string zsh_action(const OptionDescription& option) {
  switch (option.kind) {
    case ValueKind::choice:
      return fmt::format("({})", fmt::join(option.choices, " "));
    case ValueKind::file:
      return "_files";
    case ValueKind::folder:
      return "_files -/";
    case ValueKind::system:
      return "_lober_systems";
    case ValueKind::parameter:
      return "_lober_parameters";
    case ValueKind::operation:
      return "_lober_operations";
    case ValueKind::none:
    case ValueKind::other:
      break;
  }
  return " ";
}

std::string zsh_option(const OptionDescription& option) {
  const bool takes_value = option.kind != ValueKind::none;
  std::string behind = fmt::format("[{}]", zsh_escaped(short_meaning(option), "[]\\"));
  if (takes_value) behind += fmt::format(":{}:{}", zsh_escaped(option.value, ":\\"), zsh_action(option));
  std::string text;
  for (const std::string& name : option.names) {
    const char* const mark = !takes_value ? "" : name.starts_with("--") ? "=" : "+";
    const std::string others = option.names.size() > 1 ? fmt::format("({})", fmt::join(option.names, " ")) : "";
    text += fmt::format("    '{}{}{}{}' \\\n", option.repeats ? "*" : others, name, mark, behind);
  }
  return text;
}

std::string zsh_argument(const OptionDescription& argument) {
  const char* const mark = argument.repeats ? "*:" : argument.required ? ":" : "::";
  return fmt::format("    '{}{}:{}' \\\n", mark, zsh_escaped(argument.position, ":\\"), zsh_action(argument));
}

std::string zsh_function(const CompletedCommand& command) {
  std::string text = fmt::format("_lober_command_{}() {{\n  _arguments -s -S \\\n", fmt::join(command.words, "_"));
  for (const OptionDescription& option : command.options) text += zsh_option(option);
  if (command.has_one_form) {
    for (const OptionDescription& argument : command.arguments) text += zsh_argument(argument);
  } else {
    text += "    '*:curve or system:_lober_systems_and_files' \\\n";
  }
  return text + "    && return\n}\n\n";
}

// A function that offers the words with their meanings.
std::string zsh_words(const std::string& name, const std::string& tag, const std::vector<CommandExample>& words) {
  std::string text = fmt::format("_lober_{}() {{\n  local -a words_of\n  words_of=(\n", name);
  for (const CommandExample& word : words) {
    text += fmt::format("    '{}:{}'\n", zsh_escaped(word.line, ":"), zsh_escaped(word.meaning, ""));
  }
  return text + fmt::format("  )\n  _describe -t {} '{}' words_of\n}}\n\n", tag, tag);
}

std::string zsh_parameters() {
  std::string text = "_lober_parameters() {\n  local word\n  for word in $words; do\n    case $word in\n";
  for (const SystemInfo& info : list_systems()) {
    std::string names;
    for (const Parameter& parameter : info.parameters) names += " " + parameter.name + "=";
    text += fmt::format("      {}) compadd -S '' --{} ;;\n", info.name, names);
  }
  return text + "    esac\n  done\n}\n\n";
}

}  // namespace

std::string zsh_completion() {
  const std::vector<CompletedCommand> all = completed_commands();
  std::vector<CommandExample> commands, verbs, systems, operation_names;
  for (const Command& command : all_commands()) commands.push_back({command.name, command.title});
  commands.push_back({"help", "lists the options of a command"});
  for (const CompletedCommand& command : all) {
    if (command.words.size() == 2) verbs.push_back({command.words[1], command.title});
  }
  for (const SystemInfo& info : list_systems()) systems.push_back({info.name, info.summary});
  for (const operations::Operation& operation : operations::all()) {
    operation_names.push_back({operation.name, operation.title});
  }
  std::string text = "#compdef lober\n# Completions of lober for zsh: `lober --generate complete-zsh` prints them.\n\n";
  text += zsh_words("commands", "commands", commands) + zsh_words("batch_verbs", "subcommands", verbs) +
          zsh_words("system_names", "systems", systems) + zsh_words("operations", "operations", operation_names) +
          zsh_words("pages", "pages", kinds_of_pages()) + zsh_parameters();
  text += R"(_lober_systems() {
  _lober_system_names
  [[ -z $PREFIX ]] || _files
}

_lober_systems_and_files() {
  _lober_system_names
  _files
}

_lober_commands_and_files() {
  _lober_commands
  [[ -z $PREFIX ]] || _files
}

_lober_command_batch() {
  local curcontext=$curcontext state line
  _arguments -C '--help[Print this help and exit]' ':subcommand:_lober_batch_verbs' '*::argument:->rest'
  [[ $state == rest ]] || return
  (( $+functions[_lober_command_batch_$line[1]] )) && _lober_command_batch_$line[1]
}

)";
  for (const CompletedCommand& command : all) text += zsh_function(command);
  return text + R"(_lober() {
  local curcontext=$curcontext state line
  _arguments -C \
    '(- *)--help[Print the list of commands and exit]' \
    '(- *)--version[Print the version and exit]' \
    '--generate=[Print a manual page or completions]:kind:_lober_pages' \
    ':command:_lober_commands_and_files' \
    '*::argument:->rest'
  [[ $state == rest ]] || return
  if [[ $line[1] == help ]]; then
    _lober_commands
  elif (( $+functions[_lober_command_${line[1]}] )); then
    _lober_command_${line[1]}
  else
    _files
  fi
}

if [[ $funcstack[1] == _lober ]]; then _lober "$@"; else compdef _lober lober; fi
)";
}

}  // namespace lober::cli
