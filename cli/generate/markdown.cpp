#include "cli/generate/markdown.hpp"

#include <string_view>
#include <vector>

#include "cli/program/commands.hpp"

namespace lober::cli {
namespace {

std::string table_cell(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '|' || c == '<' || c == '*' || c == '\\') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

// Within backquotes only the bar of the table is special.
std::string table_code(std::string_view text) {
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? std::string("\\|") : std::string(1, c);
  return "`" + escaped + "`";
}

void add_table(std::string& text, const CommandDescription& form) {
  text += "\n| option | |\n|---|---|\n";
  for (const OptionDescription& option : form.options) {
    text += "| " + table_code(option.label()) + " | " + table_cell(option.full_meaning()) + " |\n";
  }
}

}  // namespace

std::string markdown_reference() {
  std::string text, heading;
  for (const Command& command : all_commands()) {
    for (const CommandDescription& form : forms_of(command)) {
      const std::string begin = (text.empty() ? "## " : "\n## ") + form.name + "\n\n";
      if (form.name != heading) text += begin;
      if (form.name == heading) text += "\n";
      heading = form.name;
      text += table_cell(form.summary) + "\n\n```usage\n" + form.usage() + "\n```\n";
      add_table(text, form);
    }
  }
  return text;
}

}  // namespace lober::cli
