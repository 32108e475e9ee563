#include "cli/program/help_text.hpp"

#include <algorithm>
#include <optional>

#include "cli/program/wrapped_text.hpp"

namespace lober::cli {

std::string anchor_of(std::string_view command) {
  std::string anchor(command);
  std::replace(anchor.begin(), anchor.end(), ' ', '-');
  return anchor;
}

std::string reference_line(const std::string& anchor, std::size_t width) {
  return wrapped("Reference: " + std::string(reference_page) + (anchor.empty() ? "" : "#" + anchor) +
                     " or docs/reference.md",
                 width, 2) +
         "\n";
}

std::string examples_text(const std::vector<CommandExample>& examples) {
  std::string text = "Examples:\n";
  for (const CommandExample& example : examples) text += "  " + example.line + "\n      " + example.meaning + "\n";
  return text;
}

std::string help_text(const CommandDescription& command, std::size_t width) {
  constexpr std::size_t column = 28;
  std::string text = wrapped(command.summary, width) + "\n\n";
  if (!command.examples.empty()) text += examples_text(command.examples) + "\n";
  text += "Usage: " + wrapped(command.usage(), width, 9, 7) + "\n";
  std::optional<OptionGroup> group;
  for (const OptionDescription& option : command.options) {
    if (group != option.group) {
      group = option.group;
      text += std::string("\n") + title_of(*group) + ":\n";
    }
    text += list_entry(option.label(), option.full_meaning(), column, width);
  }
  return text + "\n" + reference_line(anchor_of(command.name), width);
}

}  // namespace lober::cli
