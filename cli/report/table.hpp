// The tables that commands print: aligned text for people, or Markdown (--table md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "cli/program/option_parser.hpp"

namespace lober::cli {

enum class TableFormat : std::uint8_t { text, markdown };

/// The format of all tables of the process, text unless --table chooses.
[[nodiscard]] TableFormat table_format();
/// --table text|md, for commands that print tables.
void add_table_option(OptionParser& parser);

enum class Align : std::uint8_t { left, centre, right };

struct Column {
  std::string name;
  std::size_t width = 0;  ///< in characters; wider cells push those behind them
  Align align = Align::right;
  std::size_t gap = 1;    ///< blanks before it
  std::string unit = {};  ///< beside the name in Markdown; aligned text has no place for it
};

/// The columns of a table, which make its lines one by one, so that rows may be printed as they are ready.
class Table {
 public:
  explicit Table(std::vector<Column> columns) : columns_(std::move(columns)) {}
  void add(Column column) { columns_.push_back(std::move(column)); }

  /// The names of the columns; in Markdown two lines. Ends in a line feed, as `row`.
  [[nodiscard]] std::string head() const;
  /// The cells, perhaps fewer than there are columns; and a remark on the row, behind a gap of its own.
  [[nodiscard]] std::string row(const std::vector<std::string>& cells, std::string_view remark = {}) const;

 private:
  [[nodiscard]] std::string aligned(const std::vector<std::string>& cells) const;
  [[nodiscard]] std::string piped(std::vector<std::string> cells) const;

  std::vector<Column> columns_;
};

/// Prints a report, lines of text among which may be those of tables, to standard output. In Markdown each line that is
/// not of a table becomes an item of a list, and blank lines stand between lists and tables.
void print_report(std::string_view text);

/// The text with the characters escaped that Markdown obeys, and runs of blanks as one.
[[nodiscard]] std::string escaped_markdown(std::string_view text);

}  // namespace lober::cli
