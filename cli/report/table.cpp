#include "cli/report/table.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "cli/program/command_line.hpp"

namespace lober::cli {
namespace {

TableFormat chosen_format = TableFormat::text;

enum class MarkdownBlock : std::uint8_t { none, list, table };

// The block of Markdown that was printed last: reports may be printed in parts.
MarkdownBlock last_block = MarkdownBlock::none;

std::string padded(const std::string& cell, const Column& column) {
  switch (column.align) {
    case Align::left:
      return fmt::format("{:<{}}", cell, column.width);
    case Align::centre:
      return fmt::format("{:^{}}", cell, column.width);
    case Align::right:
      break;
  }
  return fmt::format("{:>{}}", cell, column.width);
}

const char* rule_of(Align align) {
  return align == Align::left ? ":---" : align == Align::centre ? ":---:" : "---:";
}

std::string markdown_line(std::string_view line) {
  const MarkdownBlock block = line.starts_with("| ") ? MarkdownBlock::table : MarkdownBlock::list;
  std::string text = last_block != MarkdownBlock::none && last_block != block ? "\n" : "";
  last_block = block;
  return text + (block == MarkdownBlock::table ? std::string(line) : "- " + escaped_markdown(line)) + "\n";
}

}  // namespace

TableFormat table_format() {
  return chosen_format;
}

void add_table_option(OptionParser& parser) {
  parser
      .add_call(
          "--table",
          [](const std::string& kind) { chosen_format = kind == "md" ? TableFormat::markdown : TableFormat::text; },
          "The form of what is printed: text, in aligned columns; md, tables of Markdown, and lists of the lines "
          "around "
          "them (default: text).")
      .value("KIND")
      .one_of({"text", "md"});
}

std::string escaped_markdown(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == ' ' && (escaped.empty() || escaped.back() == ' ')) continue;
    if (std::string_view("\\`*_<>|[]").find(c) != std::string_view::npos) escaped += '\\';
    escaped += c;
  }
  while (escaped.ends_with(' ')) escaped.pop_back();
  return escaped;
}

std::string Table::aligned(const std::vector<std::string>& cells) const {
  std::string line;
  for (std::size_t k = 0; k < cells.size(); ++k) line.append(columns_[k].gap, ' ') += padded(cells[k], columns_[k]);
  return line;
}

std::string Table::piped(std::vector<std::string> cells) const {
  cells.resize(columns_.size());
  std::string line = "|";
  for (const std::string& cell : cells) line += " " + escaped_markdown(cell) + " |";
  return line + "\n";
}

std::string Table::head() const {
  std::vector<std::string> names;
  for (const Column& column : columns_) names.push_back(column.name);
  if (chosen_format == TableFormat::text) return aligned(names) + "\n";
  std::string rules = "|";
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    if (!columns_[k].unit.empty()) names[k] += " (" + columns_[k].unit + ")";
    rules += std::string(" ") + rule_of(columns_[k].align) + " |";
  }
  return piped(names) + rules + "\n";
}

std::string Table::row(const std::vector<std::string>& cells, std::string_view remark) const {
  if (chosen_format == TableFormat::text) return aligned(cells) + std::string(remark) + "\n";
  std::vector<std::string> all = cells;
  if (all.size() < columns_.size()) {
    all.emplace_back(remark);
  } else {
    all.back() += std::string(remark);
  }
  return piped(all);
}

void print_report(std::string_view text) {
  if (chosen_format == TableFormat::text) return print(text);
  std::string converted;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    if (end > 0) converted += markdown_line(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  print(converted);
}

}  // namespace lober::cli
