#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "cli/generate/completions.hpp"
#include "cli/program/commands.hpp"
#include "lober/dynamics/systems.hpp"
#include "lober/operations.hpp"

namespace lober::cli {
namespace {

constexpr const char* bash_functions =
    R"sh(# Completions of lober for bash: `lober --generate complete-bash` prints them.

# Words that begin as the one under the cursor does.
_lober_words() {
  local found
  while IFS= read -r found; do COMPREPLY+=("$found"); done < <(compgen -W "$1" -- "$cur")
}

_lober_files() {
  local found
  compopt -o filenames 2>/dev/null
  while IFS= read -r found; do COMPREPLY+=("$found"); done < <(compgen "$1" -- "$cur")
}

# Values: a kind of them, or a list of words.
_lober_values() {
  case $1 in
    '') ;;
    @file) _lober_files -f ;;
    @folder) _lober_files -d ;;
    @system)
      _lober_words "$systems"
      [[ -z $cur ]] || _lober_files -f
      ;;
    @parameter)
      compopt -o nospace 2>/dev/null
      _lober_words "$(_lober_parameters)"
      ;;
    @operation) _lober_words "$operations" ;;
    *) _lober_words "$1" ;;
  esac
}

)sh";

constexpr const char* bash_end = R"sh(    *) values=@file ;;
  esac
  if [[ $cur == -* ]]; then
    _lober_words "$options"
    return
  fi
  for word in $values; do _lober_values "$word"; done
}

complete -F _lober lober
)sh";

std::string kind_word(const OptionDescription& option) {
  switch (option.kind) {
    case ValueKind::choice:
      return fmt::format("{}", fmt::join(option.choices, " "));
    case ValueKind::file:
      return "@file";
    case ValueKind::folder:
      return "@folder";
    case ValueKind::system:
      return "@system";
    case ValueKind::parameter:
      return "@parameter";
    case ValueKind::operation:
      return "@operation";
    case ValueKind::none:
    case ValueKind::other:
      break;
  }
  return "";
}

// The names of parameters of the system that is among the words, each with its equals sign.
std::string bash_parameters() {
  std::string text = "_lober_parameters() {\n  local word\n  for word in \"${COMP_WORDS[@]}\"; do\n    case $word in\n";
  for (const SystemInfo& info : list_systems()) {
    std::string names;
    for (const Parameter& parameter : info.parameters) names += (names.empty() ? "" : " ") + parameter.name + "=";
    text += fmt::format("      {}) echo '{}' ;;\n", info.name, names);
  }
  return text + "    esac\n  done\n}\n\n";
}

std::string bash_case(const CompletedCommand& command) {
  std::string text = fmt::format("    '{}')\n      case $prev in\n", fmt::join(command.words, " "));
  std::string names, values;
  for (const OptionDescription& option : command.options) {
    names += (names.empty() ? "" : " ") + fmt::format("{}", fmt::join(option.names, " "));
    if (option.kind == ValueKind::none) continue;
    text += fmt::format("        {}) _lober_values '{}'; return ;;\n", fmt::join(option.names, "|"), kind_word(option));
  }
  for (const OptionDescription& argument : command.arguments) {
    const std::string word = kind_word(argument);
    if (values.find(word) == std::string::npos) values += (values.empty() ? "" : " ") + word;
  }
  return text + fmt::format("      esac\n      options='{}'\n      values='{}'\n      ;;\n", names, values);
}

}  // namespace

std::string bash_completion() {
  std::string names, systems, kinds, verbs, operation_names;
  for (const std::string& name : command_names()) names += name + " ";
  for (const SystemInfo& info : list_systems()) systems += (systems.empty() ? "" : " ") + info.name;
  for (const CommandExample& kind : kinds_of_pages()) kinds += (kinds.empty() ? "" : " ") + kind.line;
  for (const operations::Operation& operation : operations::all()) {
    operation_names += (operation_names.empty() ? "" : " ") + operation.name;
  }
  const std::vector<CompletedCommand> commands = completed_commands();
  for (const CompletedCommand& command : commands) {
    if (command.words.size() == 2) verbs += (verbs.empty() ? "" : " ") + command.words[1];
  }
  std::string text = bash_functions + bash_parameters() + "_lober() {\n";
  text += fmt::format("  local commands='{}help'\n  local systems='{}'\n  local operations='{}'\n", names, systems,
                      operation_names);
  text += R"(  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD - 1]} options='--help' values='' word
  local command=${COMP_WORDS[1]}
  COMPREPLY=()
  # "--rule=non" comes as three words.
  if [[ $cur == '=' ]]; then
    cur=
  elif [[ $prev == '=' ]] && ((COMP_CWORD >= 2)); then
    prev=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  if ((COMP_CWORD == 1)); then
    if [[ $cur == -* ]]; then
      _lober_words '--help --version --generate'
    else
      _lober_words "$commands"
      [[ -z $cur ]] || _lober_files -f
    fi
    return
  fi
  if [[ $command == batch ]] && ((COMP_CWORD > 2)); then command="batch ${COMP_WORDS[2]}"; fi
  case $command in
    help) ((COMP_CWORD == 2)) && values=$commands ;;
    --version) options='--verbose' ;;
    --generate)
)";
  text += fmt::format("      if ((COMP_CWORD == 2)); then values='{}'; else values=$commands; fi\n      ;;\n", kinds);
  text += fmt::format("    batch) values='{}' ;;\n", verbs);
  for (const CompletedCommand& command : commands) text += bash_case(command);
  return text + bash_end;
}

}  // namespace lober::cli
