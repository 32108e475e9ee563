#include "cli/generate/completions.hpp"

#include <algorithm>

#include "cli/program/commands.hpp"

namespace lober::cli {
namespace {

std::vector<std::string> words_of(const std::string& name) {
  std::vector<std::string> words;
  for (std::size_t begin = name.find(' '); begin < name.size();) {  // behind "lober"
    const std::size_t end = std::min(name.find(' ', begin + 1), name.size());
    words.push_back(name.substr(begin + 1, end - begin - 1));
    begin = end;
  }
  return words;
}

void add_once(std::vector<OptionDescription>& list, const OptionDescription& option) {
  const bool is_there = std::any_of(list.begin(), list.end(), [&](const OptionDescription& one) {
    return one.names == option.names && one.position == option.position;
  });
  if (!is_there) list.push_back(option);
}

}  // namespace

std::vector<CompletedCommand> completed_commands() {
  std::vector<CompletedCommand> all;
  for (const Command& command : all_commands()) {
    for (const CommandDescription& form : forms_of(command)) {
      const std::vector<std::string> words = words_of(form.name);
      const bool is_new = all.empty() || all.back().words != words;
      if (is_new) {
        // Subcommands have no title of their own.
        const std::string title = words.size() == 1 ? command.title : form.summary.substr(0, form.summary.find('.'));
        all.push_back({words, title, {}, {}});
      } else {
        all.back().has_one_form = false;
      }
      for (const OptionDescription& option : form.options) {
        if (!option.position.empty()) add_once(all.back().arguments, option);
        if (!option.names.empty()) add_once(all.back().options, option);
      }
    }
  }
  return all;
}

std::vector<CommandExample> kinds_of_pages() {
  return {{"man", "manual page of lober, or of a command"}, {"complete-bash", "completions for bash"},
          {"complete-zsh", "completions for zsh"},          {"complete-fish", "completions for fish"},
          {"markdown", "reference of all commands"},        {"formats", "table of formats for the documents"},
          {"commands", "names of the commands, one a line"}};
}

std::string short_meaning(const OptionDescription& option) {
  const std::string& text = option.meaning;
  std::size_t end = text.size();
  for (const char* const stop : {". ", " (", "; ", ": "}) end = std::min(end, text.find(stop));
  while (end > 0 && text[end - 1] == '.') --end;
  return text.substr(0, end);
}

}  // namespace lober::cli
